// Tests point types that the library does not instantiate: a user's own type, and a mixed pair.
#define PCL_NO_PRECOMPILE
#include <pcl/registration/emtr_ssc.h>

#include "support.h"

/// A point as a lidar driver defines it.
struct EIGEN_ALIGN16 LidarPoint {
  PCL_ADD_POINT4D;
  float intensity;
  std::uint16_t ring;
  double time;
  PCL_MAKE_ALIGNED_OPERATOR_NEW
};

POINT_CLOUD_REGISTER_POINT_STRUCT(
    LidarPoint,
    (float, x, x)(float, y, y)(float, z, z)(float, intensity, intensity)(std::uint16_t, ring,
                                                                         ring)(double, time, time))

namespace {

TEST(OwnPoints, ATypeOfTheUsersOwn) {
  const auto source = sharedPair().source<LidarPoint>();
  (*source)[20].ring = 7;
  (*source)[20].time = 0.125;
  pcl::EMTRSSCRegistration<LidarPoint, LidarPoint> reg;
  reg.setNumberOfThreads(2);
  reg.setInputSource(source);
  reg.setInputTarget(sharedPair().target<LidarPoint>());
  pcl::PointCloud<LidarPoint> output;
  reg.align(output);
  ASSERT_TRUE(reg.hasConverged()) << reg.getReasonText();
  EXPECT_LT(sharedPair().error(reg.getFinalTransformation()), kRight);
  EXPECT_LT(reg.getFitnessScore(), 0.1);
  EXPECT_EQ(output[20].ring, 7);
  EXPECT_EQ(output[20].time, 0.125);
  EXPECT_NE(output[20].x, (*source)[20].x);
}

TEST(OwnPoints, SourceAndTargetOfDifferentTypes) {
  const auto source = sharedPair().source<pcl::PointNormal>();
  for (auto& point : *source) point.normal_z = 1.0f;
  pcl::EMTRSSCRegistration<pcl::PointNormal, pcl::PointXYZ, double> reg;
  reg.setNumberOfThreads(2);
  reg.setInputSource(source);
  reg.setInputTarget(sharedPair().target());
  pcl::PointCloud<pcl::PointNormal> output;
  reg.align(output);
  ASSERT_TRUE(reg.hasConverged()) << reg.getReasonText();
  const Eigen::Matrix4d pose = reg.getFinalTransformation();
  EXPECT_LT(sharedPair().error(pose), kRight);
  EXPECT_NEAR(output[0].normal_x, pose(0, 2), 1e-6);
  EXPECT_NEAR(output[0].normal_z, pose(2, 2), 1e-6);
}

}  // namespace
