#include <pcl/common/centroid.h>
#include <pcl/features/feature.h>
#include <pcl/features/fpfh.h>
#include <pcl/features/normal_3d.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "features/fpfh_backends.h"
#include "features/pair_features.h"
#include "geometry/pcl_cloud.h"
#include "neighbors/neighborhood.h"
#include "util/constants.h"

namespace emtr {
namespace {

/// Tells whether the covariance is exactly that of points on one line, or on one point. There PCL
/// finds no normal before 1.15, and any since.
bool is_of_line(const Eigen::Matrix3f& covariance) {
  const auto along = [&](Eigen::Index i, Eigen::Index k) {
    return covariance.row(i).cross(covariance.row(k)).isZero(0);
  };
  return along(0, 1) && along(0, 2) && along(1, 2);
}

/// A type of our own, for which PCL's class can be told how to compare two points.
struct Histograms : pcl::FPFHSignature33 {};

}  // namespace
}  // namespace emtr

// PCL's own is the only function here that is in no header of PCL.
template <>
bool pcl::FPFHEstimation<pcl::PointXYZ, pcl::Normal, emtr::Histograms>::computePairFeatures(
    const pcl::PointCloud<pcl::PointXYZ>& points, const pcl::PointCloud<pcl::Normal>& normals,
    int p, int q, float& f1, float& f2, float& f3, float& f4) {
  const auto i = static_cast<std::size_t>(p), k = static_cast<std::size_t>(q);
  const emtr::PairFeatures found =
      emtr::pair_features(points[i].data, normals[i].normal, points[k].data, normals[k].normal);
  f1 = found.f1, f2 = found.f2, f3 = found.f3, f4 = found.f4;
  return true;  // PCL counts a pair without angles too
}

namespace emtr {
namespace {

/// Runs PCL's functions over one grid. Each of the three steps searches the neighbors anew: that
/// takes a small part of the time, and all lists together could be larger than the memory.
class Description {
 public:
  Description(const Cloud& cloud, const FeatureDefinition& definition, std::size_t threads,
              const Cloud& normals)
      : definition_(definition),
        user_normals_(normals),
        points_(to_pcl(cloud)),
        grid_(cloud, std::max(definition.normal_radius, definition.feature_radius / 2)),
        scratch_(threads),
        features_{
            std::vector<float>(3 * cloud.size(), kNone),
            std::vector<float>(definition.normals_only ? 0 : kFeatureSize * cloud.size(), kNone)} {
    normals_.resize(cloud.size());
    const auto rows = static_cast<Eigen::Index>(cloud.size());
    for (Eigen::MatrixXf& histograms : histograms_) histograms.setZero(rows, kBins);
  }

  Features run(ThreadTeam& team) {
    const bool ordered = true;
    for_each_point(team, definition_.normal_radius, [this](std::size_t i, Scratch& s) {
      if (user_normals_.size()) return use_normal(row(i));
      s.neighbors.find(grid_, i, ordered, [](std::size_t) { return true; });
      estimate_normal(row(i), s.neighbors.index);
    });
    if (definition_.normals_only) return std::move(features_);
    // FPFH must not meet a NaN, so it sees only the points that have a normal.
    const auto keep = [this](std::size_t k) { return has_normal(row(k)); };
    for_each_point(team, definition_.feature_radius, [&](std::size_t i, Scratch& s) {
      if (!keep(i)) return;
      s.neighbors.find(grid_, i, !ordered, keep);  // it only counts
      const auto at = static_cast<pcl::index_t>(row(i));
      s.fpfh.computePointSPFHSignature(*points_, normals_, at, at, s.neighbors.index,
                                       histograms_[0], histograms_[1], histograms_[2]);
    });
    for_each_point(team, definition_.feature_radius, [&](std::size_t i, Scratch& s) {
      if (!keep(i)) return;
      s.neighbors.find(grid_, i, ordered, keep);
      s.fpfh.weightPointSPFHSignature(histograms_[0], histograms_[1], histograms_[2],
                                      s.neighbors.index, s.neighbors.squared, s.histogram);
      keep_histogram(row(i), s.histogram.data());
    });
    return std::move(features_);
  }

 private:
  struct Scratch {
    Neighborhood neighbors;
    pcl::FPFHEstimation<pcl::PointXYZ, pcl::Normal, Histograms> fpfh;
    Eigen::VectorXf histogram;
  };

  template <class Work>
  void for_each_point(ThreadTeam& team, double radius, const Work& work) {
    for_each_cell(grid_, team, [&](std::size_t cell, std::size_t thread) {
      Scratch& s = scratch_[thread];
      s.neighbors.set_cell(grid_, cell, radius);
      for (std::size_t i = grid_.begin(cell); i < grid_.end(cell); ++i) work(i, s);
    });
  }

  std::size_t row(std::size_t sorted) const { return static_cast<std::size_t>(grid_.rows[sorted]); }
  bool has_normal(std::size_t at) const { return std::isfinite(normals_[at].normal_x); }

  void use_normal(std::size_t at) {
    const float normal[3] = {user_normals_.x[at], user_normals_.y[at], user_normals_.z[at]};
    std::copy_n(normal, 3, normals_[at].normal);
    std::copy_n(normal, 3, &features_.normals[3 * at]);
  }

  void estimate_normal(std::size_t at, const pcl::Indices& neighbors) {
    pcl::Normal& normal = normals_[at];
    Eigen::Matrix3f covariance;
    Eigen::Vector4f centroid, plane;
    if (neighbors.size() < 3 ||
        pcl::computeMeanAndCovarianceMatrix(*points_, neighbors, covariance, centroid) == 0 ||
        is_of_line(covariance)) {
      normal.normal_x = normal.normal_y = normal.normal_z = kNone;
      return;
    }
    pcl::solvePlaneParameters(covariance, centroid, plane, normal.curvature);
    normal.normal_x = plane[0];
    normal.normal_y = plane[1];
    normal.normal_z = plane[2];
    const auto& [x, y, z] = definition_.viewpoint;
    pcl::flipNormalTowardsViewpoint((*points_)[at], x, y, z, normal.normal_x, normal.normal_y,
                                    normal.normal_z);
    if (has_normal(at)) std::copy_n(normal.normal, 3, &features_.normals[3 * at]);
  }

  void keep_histogram(std::size_t at, const float* histogram) {
    // A point alone in its neighborhood gets an empty histogram, which would match any other.
    const float sum = std::accumulate(histogram, histogram + kFeatureSize, 0.0f);
    if (std::isfinite(sum) && sum > 0)
      std::copy_n(histogram, kFeatureSize, &features_.descriptors[at * kFeatureSize]);
  }

  const FeatureDefinition& definition_;
  const Cloud& user_normals_;  // empty for none
  pcl::PointCloud<pcl::PointXYZ>::Ptr points_;
  CellGrid grid_;
  std::vector<Scratch> scratch_;
  pcl::PointCloud<pcl::Normal> normals_;
  Eigen::MatrixXf histograms_[3];  // (points, bins) of each angle
  Features features_;
};

}  // namespace

Features describe_by_pcl(const Cloud& cloud, const FeatureDefinition& definition, int threads,
                         const Cloud& normals) {
  Features out;
  Description description(cloud, definition, static_cast<std::size_t>(threads), normals);
  ThreadTeam::with(threads, [&](ThreadTeam& team) { out = description.run(team); });
  return out;
}

}  // namespace emtr
