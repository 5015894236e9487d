// Tests the class in the places where PCL uses a pcl::Registration.
#include <pcl/registration/emtr_ssc.h>
#include <pcl/registration/incremental_registration.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "support.h"

namespace {

class Usage : public SharedPairTest {};

TEST_F(Usage, ThroughTheBaseClass) {
  pcl::Registration<pcl::PointXYZ, pcl::PointXYZ>::Ptr base(new Registration);
  EXPECT_EQ(base->getClassName(), "EMTRSSCRegistration");
  base->setInputSource(source);
  base->setInputTarget(target);
  base->align(output);
  EXPECT_TRUE(base->hasConverged());
  EXPECT_LT(sharedPair().error(base->getFinalTransformation()), kRight);
  EXPECT_LT(base->getFitnessScore(), 0.1);
  base->setInputSource(Cloud::Ptr(new Cloud));
  base->align(output);
  EXPECT_FALSE(base->hasConverged());
}

TEST_F(Usage, ResidualsAreTheDistancesToTheNearestPoint) {
  EXPECT_TRUE(reg.getSourceResiduals().empty());  // there is no pose yet
  const auto indices = pcl::make_shared<pcl::Indices>();
  for (int i = 0; i < static_cast<int>(source->size()); ++i)
    if (i % 3) indices->push_back(i);
  reg.setIndices(indices);
  reg.align(output);
  const std::vector<double> of_source = reg.getSourceResiduals(),
                            of_target = reg.getTargetResiduals();
  ASSERT_EQ(of_source.size(), output.size());
  ASSERT_EQ(of_target.size(), target->size());
  const auto nearest = [](const pcl::PointXYZ& point, const Cloud& cloud) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& other : cloud)
      least = std::min(
          least, static_cast<double>((point.getVector3fMap() - other.getVector3fMap()).norm()));
    return least;
  };
  for (std::size_t i = 0; i < output.size(); i += 7)
    EXPECT_NEAR(of_source[i], nearest(output[i], *target), 2e-6) << i;
  for (std::size_t i = 0; i < target->size(); i += 7)
    EXPECT_NEAR(of_target[i], nearest((*target)[i], output), 2e-6) << i;
}

TEST_F(Usage, InAnIncrementalRegistration) {
  pcl::registration::IncrementalRegistration<pcl::PointXYZ> incremental;
  incremental.setRegistration(pcl::make_shared<Registration>());
  EXPECT_TRUE(incremental.registerCloud(target));
  EXPECT_FALSE(incremental.registerCloud(Cloud::Ptr(new Cloud)));
  EXPECT_TRUE(incremental.registerCloud(source));
  EXPECT_LT(sharedPair().error(incremental.getDeltaTransform()), kRight);
  EXPECT_LT(sharedPair().error(incremental.getAbsoluteTransform()), kRight);
}

// As PCL tests its own classes: each tree cached or not.
TEST_F(Usage, WithEachWayToCacheTheTrees) {
  reg.align(output);
  const Eigen::Matrix4f first = reg.getFinalTransformation();
  const double score = reg.getFitnessScore();
  for (const bool keep_target : {false, true})
    for (const bool keep_source : {false, true}) {
      pcl::search::KdTree<pcl::PointXYZ>::Ptr of_target(new pcl::search::KdTree<pcl::PointXYZ>);
      pcl::search::KdTree<pcl::PointXYZ>::Ptr of_source(new pcl::search::KdTree<pcl::PointXYZ>);
      // A tree that is not cached holds the wrong cloud at first.
      of_target->setInputCloud(keep_target ? target : source);
      of_source->setInputCloud(keep_source ? source : target);
      reg.setSearchMethodTarget(of_target, keep_target);
      reg.setSearchMethodSource(of_source, keep_source);
      reg.align(output);
      EXPECT_TRUE(reg.hasConverged());
      EXPECT_TRUE(sameBits(first, reg.getFinalTransformation()));
      EXPECT_EQ(score, reg.getFitnessScore());
    }
}

TEST_F(Usage, IntoTheSourceItself) {
  const pcl::PointXYZ before = (*source)[9];
  reg.align(*source);
  ASSERT_TRUE(reg.hasConverged());
  EXPECT_LT(sharedPair().error(reg.getFinalTransformation()), kRight);
  const Eigen::Vector4f moved =
      reg.getFinalTransformation() * Eigen::Vector4f(before.x, before.y, before.z, 1);
  EXPECT_NEAR((*source)[9].x, moved.x(), 1e-5);
}

TEST_F(Usage, AnOrganizedCloudStaysOrganized) {
  source->width = static_cast<std::uint32_t>(source->size() / 10);
  source->height = 10;
  source->header.frame_id = "scanner";
  reg.align(output);
  EXPECT_EQ(output.width, source->width);
  EXPECT_EQ(output.height, 10u);
  EXPECT_EQ(output.header.frame_id, "scanner");
}

TEST_F(Usage, ACopyIsIndependent) {
  reg.align(output);
  Registration copy(reg);
  copy.setSeed(9);
  copy.setInputSource(sharedPair().source());
  EXPECT_TRUE(reg.hasConverged());
  EXPECT_EQ(reg.getSeed(), 0u);
  copy.align(output);
  EXPECT_TRUE(copy.hasConverged());
  EXPECT_EQ(reg.getResult()->seed, 0u);
}

}  // namespace
