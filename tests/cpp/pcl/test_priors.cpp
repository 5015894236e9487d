// Tests the setters of the priors.
#include <pcl/registration/emtr_ssc.h>

#include <Eigen/Geometry>

#include "support.h"

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Registration = pcl::EMTRSSCRegistration<pcl::PointXYZ, pcl::PointXYZ, double>;

class Priors : public testing::Test {
 protected:
  void SetUp() override {
    reg.setNumberOfThreads(2);
    reg.setInputSource(sharedPair().source());
    reg.setInputTarget(sharedPair().target());
  }

  bool align(const Eigen::Matrix4d& guess = Eigen::Matrix4d::Identity()) {
    reg.align(output, guess);
    return reg.hasConverged();
  }
  Eigen::Matrix3d rotation() { return reg.getFinalTransformation().topLeftCorner<3, 3>(); }
  double degreesFrom(const Eigen::Matrix3d& R) {
    return Eigen::AngleAxisd(rotation() * R.transpose()).angle() * 180 / M_PI;
  }

  const Eigen::Matrix4d truth = sharedPair().pose();
  const Eigen::AngleAxisd true_rotation{Eigen::Matrix3d(truth.topLeftCorner<3, 3>())};
  Cloud output;
  Registration reg;
};

TEST_F(Priors, OnlyRotationsAboutTheAxis) {
  reg.setRotationAxis(3 * true_rotation.axis());
  ASSERT_TRUE(align()) << reg.getReasonText();
  EXPECT_LT(sharedPair().error(reg.getFinalTransformation()), kRight);
  EXPECT_LT((rotation() * true_rotation.axis() - true_rotation.axis()).norm(), 1e-8);
  const Eigen::Vector3d other = true_rotation.axis().unitOrthogonal();
  reg.setRotationAxis(other);
  EXPECT_FALSE(align());
  EXPECT_LT((rotation() * other - other).norm(), 1e-8);
  reg.clearRotationAxis();
  EXPECT_TRUE(align());
}

TEST_F(Priors, OnlyPosesNearTheGuess) {
  Eigen::Matrix4d guess = truth;
  guess.topLeftCorner<3, 3>() =
      Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitX()) * truth.topLeftCorner<3, 3>();
  reg.setGuessRadius(20, 1);
  EXPECT_TRUE(align(guess)) << reg.getReasonText();
  reg.setGuessRadius(5, 1);
  align(guess);
  EXPECT_LE(degreesFrom(guess.topLeftCorner<3, 3>()), 5 + 1e-6);
  align();  // the identity is a guess here
  EXPECT_LE(degreesFrom(Eigen::Matrix3d::Identity()), 5 + 1e-6);
  reg.clearGuessRadius();
  EXPECT_TRUE(align());
}

TEST_F(Priors, BoundsAndTheWholeRotation) {
  const Eigen::Vector3d t = truth.topRightCorner<3, 1>(), side(0.1, 0.1, 0.1);
  reg.setTranslationBounds(t - side, t + side);
  reg.setMaximumRotation(std::min(180.0, true_rotation.angle() * 180 / M_PI + 1));
  ASSERT_TRUE(align()) << reg.getReasonText();
  reg.setTranslationBounds(t + side, t + 2 * side);
  align();
  const Eigen::Vector3d found = reg.getFinalTransformation().topRightCorner<3, 1>();
  EXPECT_TRUE(((found - t - side).array() > -1e-6).all());
  reg.clearTranslationBounds();
  reg.setMaximumRotation(3);
  align();
  EXPECT_LE(degreesFrom(Eigen::Matrix3d::Identity()), 3 + 1e-6);
}

TEST_F(Priors, APresetLeavesThemAsTheyAre) {
  reg.setRotationAxis(Eigen::Vector3d::UnitZ(), 2, -10, 190);
  reg.setTranslationBounds(Eigen::Vector3d(-1, -2, -3), Eigen::Vector3d(1, 2, 3));
  reg.setMaximumRotation(50);
  reg.setGuessRadius(20, 0.5);
  ASSERT_TRUE(reg.setPreset("fast"));
  const emtr_settings s = reg.getSettings();
  EXPECT_EQ(s.has_axis, 1);
  EXPECT_EQ(s.axis[2], 1);
  EXPECT_EQ(s.axis_tilt, 2);
  EXPECT_EQ(s.axis_angle_minimum, -10);
  EXPECT_EQ(s.axis_angle_maximum, 190);
  EXPECT_EQ(s.has_translation_bounds, 1);
  EXPECT_EQ(s.translation_minimum[1], -2);
  EXPECT_EQ(s.translation_maximum[2], 3);
  EXPECT_EQ(s.maximum_rotation, 50);
  EXPECT_EQ(s.guess_rotation, 20);
  EXPECT_EQ(s.guess_translation, 0.5);
}

TEST_F(Priors, WhatContradictsIsAnError) {
  reg.setRotationAxis(Eigen::Vector3d::Zero());
  EXPECT_FALSE(align());
  EXPECT_NE(reg.getErrorMessage().find("'axis'"), std::string::npos) << reg.getErrorMessage();
  reg.setRotationAxis(Eigen::Vector3d::UnitZ(), 0, 50, 90);
  reg.setMaximumRotation(40);
  EXPECT_FALSE(align());
  EXPECT_NE(reg.getErrorMessage().find("'maximum_rotation'"), std::string::npos)
      << reg.getErrorMessage();
}

}  // namespace
