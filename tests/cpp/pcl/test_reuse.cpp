// Tests one target with many sources: what is cached between two calls of align(), and what is not.
#include <pcl/registration/emtr_ssc.h>

#include <cstring>

#include "support.h"

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Registration = pcl::EMTRSSCRegistration<pcl::PointXYZ, pcl::PointXYZ>;

Eigen::Matrix4f fresh(const Cloud::Ptr& source, const Cloud::Ptr& target) {
  Registration reg;
  Cloud output;
  reg.setNumberOfThreads(2);
  reg.setInputSource(source);
  reg.setInputTarget(target);
  reg.align(output);
  EXPECT_NE(reg.getResult(), nullptr) << reg.getErrorMessage();
  return reg.getFinalTransformation();
}

Eigen::Matrix4f again(Registration& reg) {
  Cloud output;
  reg.align(output);
  return reg.getFinalTransformation();
}

TEST(Reuse, ManySourcesAgainstOneTargetGiveTheBitsOfFreshObjects) {
  const Pair other(1, 2500);
  const Cloud::Ptr target = sharedPair().target();
  Registration reg;
  reg.setNumberOfThreads(2);
  reg.setInputTarget(target);
  for (const Cloud::Ptr& source : {sharedPair().source(), other.source(), sharedPair().source()}) {
    reg.setInputSource(source);
    EXPECT_TRUE(sameBits(again(reg), fresh(source, target)));
  }
  const Cloud::Ptr second = other.target();
  reg.setInputTarget(second);
  EXPECT_TRUE(sameBits(again(reg), fresh(sharedPair().source(), second)));
}

TEST(Reuse, ChangesOfPointsInPlaceAndOfIndicesAreSeen) {
  const Cloud::Ptr source = sharedPair().source(), target = sharedPair().target();
  Registration reg;
  reg.setNumberOfThreads(2);
  reg.setInputSource(source);
  reg.setInputTarget(target);
  const Eigen::Matrix4f first = again(reg);
  EXPECT_TRUE(sameBits(again(reg), first));

  for (auto& point : *source) point.x += 3.0f;
  const Eigen::Matrix4f moved = again(reg);
  EXPECT_FALSE(sameBits(moved, first));
  EXPECT_TRUE(sameBits(moved, fresh(source, target)));
  for (auto& point : *target) point.y -= 2.0f;
  EXPECT_TRUE(sameBits(again(reg), fresh(source, target)));
  (*target)[5].z = kNaN;
  again(reg);
  EXPECT_EQ(reg.getResult()->dropped_target, 1u);

  pcl::IndicesPtr some(new pcl::Indices);
  for (pcl::index_t i = 0; i < 2000; ++i) some->push_back(i);
  reg.setIndices(some);
  again(reg);
  EXPECT_EQ(reg.getResult()->points_source, 2000u);
}

TEST(Reuse, AnUnchangedCloudIsPreprocessedOnce) {
  Cloud::Ptr cloud = sharedPair().source();
  (*cloud)[9].x = kNaN;
  pcl::detail::CachedCloud cache;
  const auto first = cache.get(*cloud, "source", 1);
  ASSERT_NE(first, nullptr);
  EXPECT_EQ(cache.get(*cloud, "source", 2), first);
  const Cloud copy = *cloud;
  EXPECT_EQ(cache.get(copy, "source", 1), first);
  (*cloud)[77].z += 1e-6f;
  const auto second = cache.get(*cloud, "source", 1);
  EXPECT_NE(second, first);
  cloud->push_back(pcl::PointXYZ(1, 2, 3));
  EXPECT_NE(cache.get(*cloud, "source", 1), second);
}

TEST(Reuse, AfterAnErrorTheCloudIsPreprocessedAgain) {
  pcl::detail::CachedCloud cache;
  Cloud few(4, 1);
  EXPECT_EQ(cache.get(few, "source", 1), nullptr);
  EXPECT_NE(std::strstr(emtr_error_message(), "source cloud: 4 finite points"), nullptr);
  EXPECT_EQ(cache.get(few, "source", 1), nullptr);
  EXPECT_NE(cache.get(*sharedPair().source(), "source", 1), nullptr);
}

TEST(Reuse, ThePreprocessingCountsInTheTimings) {
  const Pair large(1, 250000);
  Registration reg;
  reg.setNumberOfThreads(1);
  reg.setMaximumIterations(2);
  reg.setInputSource(large.source());
  reg.setInputTarget(large.target());
  again(reg);
  const auto first = reg.getResult();
  again(reg);
  ASSERT_NE(reg.getResult(), nullptr);
  EXPECT_GT(first->seconds_normalization, 2 * reg.getResult()->seconds_normalization);
  EXPECT_GE(first->seconds_total, first->seconds_normalization);
}

}  // namespace
