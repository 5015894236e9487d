#pragma once

#include <pcl/point_cloud.h>

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <vector>

namespace pcl {
namespace detail {

/** \brief Packs x, y, z of all points. Reserves storage even for no points, so that the address is
 * never null. */
template <typename PointT>
std::vector<float> packPoints(const PointCloud<PointT>& cloud) {
  std::vector<float> packed;
  packed.reserve(3 * cloud.size() + 1);
  for (const auto& point : cloud) {
    packed.push_back(point.x);
    packed.push_back(point.y);
    packed.push_back(point.z);
  }
  return packed;
}

/** \brief Packs the colors, 0 to 1, of a point type that has some. */
template <typename PointT>
auto packColors(const PointCloud<PointT>& cloud, int)
    -> decltype(static_cast<void>(PointT::r), std::vector<float>()) {
  std::vector<float> packed;
  packed.reserve(3 * cloud.size() + 1);
  for (const auto& point : cloud)
    for (const auto channel : {point.r, point.g, point.b})
      packed.push_back(static_cast<float>(channel) / 255.0f);
  return packed;
}

/** \brief Packs nothing of a point type without colors. */
template <typename PointT>
std::vector<float> packColors(const PointCloud<PointT>&, long) {
  return {};
}

/** \brief Packs the intensities of a point type that has some. */
template <typename PointT>
auto packIntensities(const PointCloud<PointT>& cloud, int)
    -> decltype(static_cast<void>(PointT::intensity), std::vector<float>()) {
  std::vector<float> packed;
  packed.reserve(cloud.size() + 1);
  for (const auto& point : cloud) packed.push_back(point.intensity);
  return packed;
}

/** \brief Packs nothing of a point type without intensities. */
template <typename PointT>
std::vector<float> packIntensities(const PointCloud<PointT>&, long) {
  return {};
}

/** \brief Rotates the normal of a point whose type has one. */
template <typename PointT>
auto rotateNormal(PointT& point, const Eigen::Matrix3d& rotation, int)
    -> decltype(static_cast<void>(point.normal_x)) {
  const Eigen::Vector3d normal(point.normal_x, point.normal_y, point.normal_z);
  const Eigen::Vector3f rotated = (rotation * normal).template cast<float>();
  point.normal_x = rotated.x();
  point.normal_y = rotated.y();
  point.normal_z = rotated.z();
}

/** \brief Does nothing for a point type without a normal. */
template <typename PointT>
void rotateNormal(PointT&, const Eigen::Matrix3d&, long) {}

/** \brief Moves the finite points and rotates their normals; leaves all else as it is. `scale`: of
 * the transformation, which normals do not take. */
template <typename PointT>
void transformPoints(PointCloud<PointT>& cloud, const Eigen::Matrix4d& transformation,
                     double scale) {
  const Eigen::Matrix3d rotation = transformation.topLeftCorner<3, 3>() / scale;
  for (auto& point : cloud) {
    if (!std::isfinite(point.x) || !std::isfinite(point.y) || !std::isfinite(point.z)) continue;
    const Eigen::Vector3d position(point.x, point.y, point.z);
    const Eigen::Vector3f moved =
        (transformation.topLeftCorner<3, 3>() * position + transformation.topRightCorner<3, 1>())
            .template cast<float>();
    point.x = moved.x();
    point.y = moved.y();
    point.z = moved.z();
    rotateNormal(point, rotation, 0);
  }
}

}  // namespace detail
}  // namespace pcl
