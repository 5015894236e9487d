// Tests the inputs: indices, points that are not finite, empty and missing clouds, wrong settings.
#include <pcl/registration/emtr_ssc.h>

#include "support.h"

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Registration = pcl::EMTRSSCRegistration<pcl::PointXYZ, pcl::PointXYZ>;

class Inputs : public testing::Test {
 protected:
  void SetUp() override {
    reg.setNumberOfThreads(2);
    reg.setInputSource(source);
    reg.setInputTarget(target);
  }

  /// Expects no pose, nothing that looks like one, and `word` in the message.
  void expectNoPose(const std::string& word) {
    EXPECT_FALSE(reg.hasConverged());
    EXPECT_TRUE(allNaN(reg.getFinalTransformation()));
    EXPECT_EQ(reg.getResult(), nullptr);
    EXPECT_NE(reg.getErrorMessage().find(word), std::string::npos) << reg.getErrorMessage();
  }

  Cloud::Ptr source = sharedPair().source();
  Cloud::Ptr target = sharedPair().target();
  Cloud output;
  Registration reg;
};

TEST_F(Inputs, OnlyTheIndexedPointsAreRegisteredAndPutOut) {
  // Every other point is moved far away, where it would spoil the pose.
  pcl::IndicesPtr indices(new pcl::Indices);
  for (std::size_t i = 0; i < source->size(); ++i) {
    if (i % 2 == 0)
      indices->push_back(static_cast<pcl::index_t>(i));
    else
      (*source)[i].x += 50.0f;
  }
  reg.setIndices(indices);
  reg.align(output);
  ASSERT_TRUE(reg.hasConverged()) << reg.getReasonText();
  EXPECT_LT(sharedPair().error(reg.getFinalTransformation()), kRight);
  EXPECT_EQ(reg.getResult()->points_source, indices->size());
  ASSERT_EQ(output.size(), indices->size());
  for (std::size_t i = 0; i < output.size(); ++i) {
    const pcl::PointXYZ& p = (*source)[2 * i];
    const Eigen::Vector4f moved = reg.getFinalTransformation() * Eigen::Vector4f(p.x, p.y, p.z, 1);
    ASSERT_NEAR(output[i].x, moved.x(), 1e-5);
    ASSERT_NEAR(output[i].y, moved.y(), 1e-5);
    ASSERT_NEAR(output[i].z, moved.z(), 1e-5);
  }
}

TEST_F(Inputs, NoIndexedPointIsAnError) {
  reg.setIndices(pcl::IndicesPtr(new pcl::Indices));
  reg.align(output);
  EXPECT_TRUE(output.empty());
  expectNoPose("source");
}

TEST_F(Inputs, PointsThatAreNotFiniteAreDroppedCountedAndLeftAsTheyAre) {
  (*source)[2].x = kNaN;
  (*source)[3].y = kNaN;
  (*source)[4].z = std::numeric_limits<float>::infinity();
  (*target)[0].x = kNaN;
  source->is_dense = target->is_dense = false;
  reg.align(output);
  ASSERT_TRUE(reg.hasConverged()) << reg.getReasonText();
  EXPECT_LT(sharedPair().error(reg.getFinalTransformation()), kRight);
  EXPECT_EQ(reg.getResult()->dropped_source, 3u);
  EXPECT_EQ(reg.getResult()->dropped_target, 1u);
  EXPECT_EQ(output[2].y, (*source)[2].y);
  EXPECT_EQ(output[3].x, (*source)[3].x);
  EXPECT_TRUE(std::isnan(output[3].y));
  EXPECT_EQ(output[4].x, (*source)[4].x);
  EXPECT_TRUE(std::isinf(output[4].z));
  EXPECT_NE(output[5].x, (*source)[5].x);
}

TEST_F(Inputs, FitnessScoreIsSafeBesidePointsThatAreNotFinite) {
  reg.align(output);
  const double clean = reg.getFitnessScore();
  EXPECT_GT(clean, 0.0);
  EXPECT_LT(clean, 0.1);
  for (std::size_t i = 0; i < 10; ++i) (*source)[i].x = (*target)[i].x = kNaN;
  reg.setInputTarget(target);
  reg.align(output);
  EXPECT_NEAR(reg.getFitnessScore(), clean, 0.01);  // no abort, no NaN
}

TEST_F(Inputs, FitnessScoreOfNoPoseIsTheWorst) {
  constexpr double worst = std::numeric_limits<double>::max();
  EXPECT_EQ(reg.getFitnessScore(), worst);  // before align()
  for (auto& point : *target) point.x = kNaN;
  reg.setInputTarget(target);
  reg.align(output);
  expectNoPose("target");
  EXPECT_EQ(reg.getFitnessScore(), worst);
}

TEST_F(Inputs, AnErrorIsReportedAndLeavesTheOutputUntransformed) {
  reg.align(output);
  ASSERT_TRUE(reg.hasConverged());
  Cloud::Ptr few(new Cloud(4, 1));
  (*few)[1].x = (*few)[2].y = (*few)[3].z = 1.0f;
  reg.setInputSource(few);
  testing::internal::CaptureStderr();
  reg.align(output);
  EXPECT_NE(testing::internal::GetCapturedStderr().find("EMTRSSCRegistration::align"),
            std::string::npos);
  expectNoPose("source");
  EXPECT_EQ(reg.getReasonText(), reg.getErrorMessage());
  ASSERT_EQ(output.size(), 4u);
  EXPECT_EQ(output[2].y, 1.0f);
  EXPECT_EQ(output[2].x, 0.0f);

  reg.setInputSource(source);  // and is over with the next good input
  reg.align(output);
  EXPECT_TRUE(reg.hasConverged());
  EXPECT_EQ(reg.getErrorMessage(), "");
}

TEST_F(Inputs, AnEmptyOrNullSourceDropsTheOldOne) {
  for (const auto& cloud : {Cloud::Ptr(), Cloud::Ptr(new Cloud)}) {
    reg.setInputSource(source);
    reg.align(output);
    ASSERT_TRUE(reg.hasConverged());
    reg.setInputSource(cloud);
    EXPECT_EQ(reg.getInputSource(), nullptr);
    expectNoPose("source");
    reg.align(output);
    expectNoPose("source");
    reg.setInputTarget(target);  // the other setter does not hide what is missing
    expectNoPose("source");
  }
}

TEST_F(Inputs, AnEmptyOrNullTargetDropsTheOldOne) {
  for (const auto& cloud : {Cloud::Ptr(), Cloud::Ptr(new Cloud)}) {
    reg.setInputTarget(target);
    reg.align(output);
    ASSERT_TRUE(reg.hasConverged());
    reg.setInputTarget(cloud);
    EXPECT_EQ(reg.getInputTarget(), nullptr);
    reg.align(output);
    expectNoPose("target");
  }
}

TEST_F(Inputs, ANewInputResetsTheResult) {
  reg.align(output);
  ASSERT_TRUE(reg.hasConverged());
  const Registration::ResultConstPtr kept = reg.getResult();
  reg.setInputTarget(target);
  EXPECT_FALSE(reg.hasConverged());
  EXPECT_EQ(reg.getResult(), nullptr);
  EXPECT_EQ(reg.getReasonText(), "");
  EXPECT_TRUE(allNaN(reg.getFinalTransformation()));
  EXPECT_EQ(kept->registered, 1);  // whoever holds the result may keep it
}

TEST_F(Inputs, AMissingInputIsNamed) {
  Registration fresh;
  fresh.align(output);
  EXPECT_FALSE(fresh.hasConverged());
  EXPECT_NE(fresh.getErrorMessage().find("source"), std::string::npos);
  fresh.setInputSource(source);
  fresh.align(output);
  EXPECT_NE(fresh.getErrorMessage().find("target"), std::string::npos);
}

TEST_F(Inputs, AWrongSettingIsNamed) {
  reg.setMaximumIterations(-5);
  reg.align(output);
  expectNoPose("iterations");
  reg.setMaximumIterations(100);
  Eigen::Matrix4f shear = Eigen::Matrix4f::Identity();
  shear(0, 1) = 0.5f;
  reg.align(output, shear);
  expectNoPose("guess");
}

}  // namespace
