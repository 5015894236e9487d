// Tests every instantiated point type and scalar: pose, precision, output and its fields.
#include <pcl/registration/emtr_ssc.h>

#include <type_traits>

#include "support.h"

namespace {

template <typename PointT, typename ScalarT>
struct Case {
  using Point = PointT;
  using Scalar = ScalarT;
};

template <typename PointT>
constexpr bool hasNormal() {
  return std::is_same<PointT, pcl::PointNormal>::value ||
         std::is_same<PointT, pcl::PointXYZINormal>::value ||
         std::is_same<PointT, pcl::PointXYZRGBNormal>::value;
}

/// Writes to each field that the registration does not change.
void mark(pcl::PointXYZ&, float) {}
void mark(pcl::PointXYZI& p, float value) { p.intensity = value; }
void mark(pcl::PointXYZRGB& p, float value) { p.r = static_cast<std::uint8_t>(value); }
void mark(pcl::PointXYZRGBA& p, float value) { p.r = static_cast<std::uint8_t>(value); }
void mark(pcl::PointXYZRGBNormal& p, float value) { p.r = static_cast<std::uint8_t>(value); }
void mark(pcl::PointNormal& p, float value) { p.curvature = value; }
void mark(pcl::PointXYZINormal& p, float value) { p.curvature = p.intensity = value; }
float marked(const pcl::PointXYZ&, float value) { return value; }
float marked(const pcl::PointXYZI& p, float) { return p.intensity; }
float marked(const pcl::PointXYZRGB& p, float) { return p.r; }
float marked(const pcl::PointXYZRGBA& p, float) { return p.r; }
float marked(const pcl::PointXYZRGBNormal& p, float) { return p.r; }
float marked(const pcl::PointNormal& p, float) { return p.curvature; }
float marked(const pcl::PointXYZINormal& p, float) { return (p.curvature + p.intensity) / 2; }

template <typename PointT>
void setNormal(PointT& p, const Eigen::Vector3f& n, std::true_type) {
  p.normal_x = n.x();
  p.normal_y = n.y();
  p.normal_z = n.z();
}
template <typename PointT>
void setNormal(PointT&, const Eigen::Vector3f&, std::false_type) {}
template <typename PointT>
Eigen::Vector3f normalOf(const PointT& p, const Eigen::Vector3f&, std::true_type) {
  return {p.normal_x, p.normal_y, p.normal_z};
}
template <typename PointT>
Eigen::Vector3f normalOf(const PointT&, const Eigen::Vector3f& expected, std::false_type) {
  return expected;
}

template <typename C>
class Types : public testing::Test {};

using Cases =
    testing::Types<Case<pcl::PointXYZ, float>, Case<pcl::PointXYZ, double>,
                   Case<pcl::PointXYZI, float>, Case<pcl::PointXYZI, double>,
                   Case<pcl::PointXYZRGB, float>, Case<pcl::PointXYZRGB, double>,
                   Case<pcl::PointXYZRGBA, float>, Case<pcl::PointXYZRGBA, double>,
                   Case<pcl::PointXYZRGBNormal, float>, Case<pcl::PointXYZRGBNormal, double>,
                   Case<pcl::PointNormal, float>, Case<pcl::PointNormal, double>,
                   Case<pcl::PointXYZINormal, float>, Case<pcl::PointXYZINormal, double>>;
TYPED_TEST_SUITE(Types, Cases);

TYPED_TEST(Types, GiveTheSamePoseAndAMovedCopy) {
  using PointT = typename TypeParam::Point;
  using Scalar = typename TypeParam::Scalar;
  const std::integral_constant<bool, hasNormal<PointT>()> normals{};
  const Eigen::Vector3f normal(0.6f, 0.0f, 0.8f);
  const auto source = sharedPair().source<PointT>();
  for (std::size_t i = 0; i < source->size(); ++i) {
    mark((*source)[i], static_cast<float>(i % 200));
    setNormal((*source)[i], normal, normals);
  }

  pcl::EMTRSSCRegistration<PointT, PointT, Scalar> reg;
  reg.setNumberOfThreads(2);
  reg.setInputSource(source);
  reg.setInputTarget(sharedPair().target<PointT>());
  pcl::PointCloud<PointT> output;
  reg.align(output);

  ASSERT_TRUE(reg.hasConverged()) << reg.getReasonText();
  EXPECT_EQ(reg.getErrorMessage(), "");
  const Eigen::Matrix<Scalar, 4, 4> pose = reg.getFinalTransformation();
  EXPECT_LT(sharedPair().error(pose), kRight);
  EXPECT_TRUE(sameBits(pose, reg.getLastIncrementalTransformation()));

  // The pose has the library's digits, in the scalar of the class.
  const double* rows = reg.getResult()->transformation;
  for (int i = 0; i < 16; ++i) EXPECT_EQ(pose(i / 4, i % 4), static_cast<Scalar>(rows[i]));
  if (std::is_same<Scalar, double>::value) {
    const Eigen::Matrix3d r = pose.template topLeftCorner<3, 3>().template cast<double>();
    EXPECT_LT((r * r.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-12);
  }

  // The point type does not change the pose.
  static Eigen::Matrix4f first = pose.template cast<float>();
  EXPECT_TRUE(sameBits(first, Eigen::Matrix4f(pose.template cast<float>())));

  ASSERT_EQ(output.size(), source->size());
  const Eigen::Matrix4d move = pose.template cast<double>();
  const Eigen::Vector3f rotated =
      (move.topLeftCorner<3, 3>() * normal.cast<double>()).cast<float>();
  for (std::size_t i = 0; i < output.size(); ++i) {
    const PointT& p = (*source)[i];
    const Eigen::Vector4d moved = move * Eigen::Vector4d(p.x, p.y, p.z, 1.0);
    ASSERT_NEAR(output[i].x, moved.x(), 1e-6);
    ASSERT_NEAR(output[i].y, moved.y(), 1e-6);
    ASSERT_NEAR(output[i].z, moved.z(), 1e-6);
    const auto value = static_cast<float>(i % 200);
    ASSERT_EQ(marked(output[i], value), value);
    ASSERT_LT((normalOf(output[i], rotated, normals) - rotated).norm(), 1e-6);
  }
}

}  // namespace
