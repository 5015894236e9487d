// Tests viewpoints: set, taken from the clouds, or unknown.
#include <pcl/registration/emtr_ssc.h>

#include "support.h"

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Registration = pcl::EMTRSSCRegistration<pcl::PointXYZ, pcl::PointXYZ>;

class Viewpoints : public testing::Test {
 protected:
  void SetUp() override {
    reg.setNumberOfThreads(2);
    ASSERT_TRUE(reg.setPreset("thorough"));  // whose fallback search uses viewpoints
    reg.setInputSource(source);
    reg.setInputTarget(target);
    // Far out on the scanned side of each cloud; the target's frame is the ball's own.
    of_target = 20.0f * Eigen::Vector3f(-0.35f, 0.0f, 0.94f);
    const Eigen::Matrix4d back = sharedPair().pose().inverse();
    of_source = (back * Eigen::Vector4d(7.0, 0.0, 18.8, 1.0)).head<3>().cast<float>();
    unknown = score();
  }

  /// Returns the score, which depends on the viewpoints and so distinguishes the runs.
  double score() {
    reg.align(output);
    EXPECT_TRUE(reg.hasConverged()) << reg.getReasonText();
    EXPECT_LT(sharedPair().error(reg.getFinalTransformation()), kRight);
    return reg.getResult() ? reg.getResult()->score : kNaN;
  }

  Cloud::Ptr source = sharedPair().source();
  Cloud::Ptr target = sharedPair().target();
  Cloud output;
  Registration reg;
  Eigen::Vector3f of_source, of_target;
  double unknown = 0;
};

TEST_F(Viewpoints, ThoseOfTheCloudsAreThoseThatAreSet) {
  reg.setSourceViewpoint(of_source);
  reg.setTargetViewpoint(of_target);
  const double set = score();
  EXPECT_NE(set, unknown);
  reg.clearSourceViewpoint();
  reg.clearTargetViewpoint();
  EXPECT_EQ(score(), unknown);

  source->sensor_origin_.head<3>() = of_source;
  target->sensor_origin_.head<3>() = of_target;
  EXPECT_EQ(score(), set);
  source->sensor_origin_.setZero();  // what PCL gives every cloud: unknown
  target->sensor_origin_.setZero();
  EXPECT_EQ(score(), unknown);
}

TEST_F(Viewpoints, WhatIsSetGoesBeforeTheCloudsOwn) {
  reg.setSourceViewpoint(of_source);
  reg.setTargetViewpoint(of_target);
  const double set = score();
  source->sensor_origin_ << 1.0f, 2.0f, 3.0f, 0.0f;
  EXPECT_EQ(score(), set);
  ASSERT_TRUE(reg.setPreset("thorough"));  // leaves them as they are
  reg.setNumberOfThreads(2);
  EXPECT_EQ(score(), set);
  reg.setSettings(reg.getSettings());  // and these have them
  EXPECT_EQ(score(), set);
}

TEST_F(Viewpoints, TheOriginIsAPlaceWhenItIsSet) {
  for (auto& point : *target) point.getVector3fMap() -= of_target;
  target->sensor_origin_.setZero();
  source->sensor_origin_.head<3>() = of_source;
  reg.setInputTarget(target);
  const auto moved_score = [&] {
    reg.align(output);
    return reg.getResult()->score;
  };
  const double one_known = moved_score();
  reg.setTargetViewpoint(Eigen::Vector3f::Zero());
  EXPECT_NE(moved_score(), one_known);
  EXPECT_EQ(reg.getSettings().has_viewpoint_target, 1);
}

TEST_F(Viewpoints, OneThatIsNotFiniteIsAnError) {
  reg.setSourceViewpoint({0.0f, kNaN, 0.0f});
  reg.align(output);
  EXPECT_FALSE(reg.hasConverged());
  EXPECT_NE(reg.getErrorMessage().find("viewpoint_source"), std::string::npos)
      << reg.getErrorMessage();
  reg.clearSourceViewpoint();
  target->sensor_origin_.x() = std::numeric_limits<float>::infinity();
  reg.align(output);
  EXPECT_FALSE(reg.hasConverged());
  EXPECT_NE(reg.getErrorMessage().find("viewpoint_target"), std::string::npos)
      << reg.getErrorMessage();
  reg.setTargetViewpoint(of_target);
  reg.align(output);
  EXPECT_TRUE(reg.hasConverged());
}

}  // namespace
