#include "neighbors/scattered_points.h"

#include <pcl/kdtree/kdtree_flann.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/pcl_cloud.h"

namespace emtr {
namespace {

constexpr std::size_t kNearest = 8;
constexpr double kFarther = 1.6;     // than the median, from its neighbors
constexpr double kVariation = 0.05;  // of a surface: smallest eigenvalue by the sum of all three
constexpr double kShare = 0.1;       // of the points at least
constexpr int kRounds = 3;

struct Neighborhood {
  double distance;   ///< mean, to the neighbors
  double variation;  ///< 0 on a plane, 1/3 in space
};

Neighborhood neighborhood(const pcl::PointCloud<pcl::PointXYZ>& cloud, const pcl::Indices& index,
                          const std::vector<float>& squared) {
  const auto count = static_cast<double>(index.size());
  double distance = 0;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < index.size(); ++k) {
    distance += std::sqrt(double{squared[k]}) / (count - 1);  // the point itself is among them
    mean += cloud[static_cast<std::size_t>(index[k])].getVector3fMap().cast<double>() / count;
  }
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const auto i : index) {
    const Eigen::Vector3d d =
        cloud[static_cast<std::size_t>(i)].getVector3fMap().cast<double>() - mean;
    covariance += d * d.transpose();
  }
  const Eigen::Vector3d values =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance, Eigen::EigenvaluesOnly)
          .eigenvalues();
  const double sum = values.sum();
  return {distance, sum > 0 ? values[0] / sum : 0};
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::vector<Neighborhood> neighborhoods(const Cloud& cloud) {
  const auto points = to_pcl(cloud);
  pcl::KdTreeFLANN<pcl::PointXYZ> tree;
  tree.setInputCloud(points);
  std::vector<Neighborhood> out;
  pcl::Indices index;
  std::vector<float> squared;
  for (const pcl::PointXYZ& p : *points) {
    tree.nearestKSearch(p, kNearest + 1, index, squared);
    out.push_back(neighborhood(*points, index, squared));
  }
  return out;
}

struct Selection {
  std::vector<std::size_t> rows;
  std::size_t flat = 0;  ///< how many of them lie on a plane with their neighbors
};

/// Returns those of the rows whose points are not scattered among the points of these rows.
Selection select_surface(const Cloud& cloud, const std::vector<std::size_t>& rows) {
  if (rows.size() <= kNearest) return {rows, rows.size()};
  const std::vector<Neighborhood> around = neighborhoods(cloud.select(rows));
  std::vector<double> distances;
  distances.reserve(around.size());
  for (const Neighborhood& n : around) distances.push_back(n.distance);
  const double far = kFarther * median(distances);
  if (far == 0) return {rows, rows.size()};  // most points are there many times
  Selection out;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const bool flat = around[i].variation <= kVariation;
    if (around[i].distance <= far || flat) out.rows.push_back(rows[i]);
    out.flat += flat;
  }
  return out;
}

}  // namespace

std::vector<std::size_t> rows_on_surface(const Cloud& cloud) {
  std::vector<std::size_t> all(cloud.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  Selection left = select_surface(cloud, all);
  const auto scattered = static_cast<double>(all.size() - left.rows.size());
  if (scattered < kShare * static_cast<double>(all.size())) return all;
  // Outliers that lay near each other are farther from their neighbors now.
  for (int round = 1; round < kRounds; ++round) left = select_surface(cloud, left.rows);
  return 2 * left.flat < left.rows.size() ? all : left.rows;
}

}  // namespace emtr
