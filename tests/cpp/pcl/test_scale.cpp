// A source of another scale, by the class.
#include "support.h"

namespace {

using Registration = pcl::EMTRSSCRegistration<pcl::PointNormal, pcl::PointNormal>;

TEST(Scale, ASimilarityIsFoundAndNormalsKeepTheirLength) {
  const Pair pair(2, 4000);
  const auto source = pair.source<pcl::PointNormal>();
  for (auto& point : *source) {
    point.getVector3fMap() *= 25.4f;
    point.getNormalVector3fMap() = Eigen::Vector3f(0, 0, 1);
  }
  Registration registration;
  registration.setPreset("fast");
  EXPECT_TRUE(std::isnan(registration.getScale()));
  registration.setInputSource(source);
  registration.setInputTarget(pair.target<pcl::PointNormal>());
  registration.setScaleToUnits();
  pcl::PointCloud<pcl::PointNormal> output;
  registration.align(output);
  ASSERT_TRUE(registration.hasConverged());
  EXPECT_EQ(registration.getScale(), 1 / 25.4);
  Eigen::Matrix4d rigid = registration.getFinalTransformation().cast<double>();
  rigid.topLeftCorner<3, 3>() *= 25.4;
  EXPECT_LT(pair.error(rigid), 0.03);
  for (const auto& point : output) {
    EXPECT_NEAR(point.getNormalVector3fMap().norm(), 1, 1e-5);
    EXPECT_LT(point.getVector3fMap().norm(), 10);
  }
}

TEST(Scale, OfAKnownFactorBoundsAndAnyAreSettings) {
  Registration registration;
  registration.setScaleBounds(0.5, 2);
  EXPECT_EQ(registration.getSettings().scale, EMTR_SCALE_BOUNDED);
  EXPECT_EQ(registration.getSettings().scale_maximum, 2);
  registration.setScaleFree();
  EXPECT_EQ(registration.getSettings().scale, EMTR_SCALE_FREE);
  EXPECT_EQ(registration.getSettings().scale_maximum, 1);
  registration.setScaleBounds(1, 1);
  EXPECT_EQ(registration.getSettings().scale, EMTR_SCALE_FIXED);
  registration.setScaleFree();
  registration.clearScale();
  EXPECT_EQ(registration.getSettings().scale, EMTR_SCALE_FIXED);
}

}  // namespace
