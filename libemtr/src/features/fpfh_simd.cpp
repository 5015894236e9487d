#include <algorithm>
#include <cmath>
#include <utility>

#include "features/fpfh_backends.h"
#include "util/constants.h"
#include "voxels/cell_grid.h"

namespace emtr {
namespace {

/// Runs the kernels over one grid.
class Description {
 public:
  Description(const Cloud& cloud, const FeatureDefinition& definition, const Kernels& kernels,
              std::size_t threads, const Cloud& normals)
      : definition_(definition),
        kernels_(kernels),
        user_normals_(normals),
        n_(cloud.size()),
        grid_(cloud, std::max(definition.normal_radius, definition.feature_radius / 2)),
        scratch_(threads),
        moments_(kMoments * n_),
        histograms_(kDescriptorRow * n_) {
    features_.normals.resize(3 * n_);
    if (!definition.normals_only) features_.descriptors.assign(kDescriptor * n_, kNone);
  }

  Features run(ThreadTeam& team) {
    if (user_normals_.size())
      normals_ = user_normals_.select(grid_.rows);
    else
      estimate_normals(team);
    write_normals();
    if (definition_.normals_only) return std::move(features_);
    for_each_cell(grid_, team, [this](std::size_t cell, std::size_t thread) {
      pair_histograms(cell, scratch_[thread]);
    });
    for_each_cell(grid_, team, [this](std::size_t cell, std::size_t thread) {
      weigh_histograms(cell, scratch_[thread]);
    });
    return std::move(features_);
  }

 private:
  struct Scratch {
    std::vector<CellGrid::Range> ranges;
    NeighborList list;
    Cloud normals;  // of the list
  };

  void gather(std::size_t cell, double radius, const Cloud& points, Scratch& s) const {
    grid_.around(cell, grid_.reach(radius), s.ranges);
    s.list.gather(points, s.ranges);
  }

  std::array<float, 3> point(std::size_t i) const {
    return {grid_.sorted.x[i], grid_.sorted.y[i], grid_.sorted.z[i]};
  }
  bool has_normal(std::size_t i) const { return normals_.x[i] == normals_.x[i]; }

  void estimate_normals(ThreadTeam& team) {
    for_each_cell(grid_, team, [this](std::size_t cell, std::size_t thread) {
      Scratch& s = scratch_[thread];
      gather(cell, definition_.normal_radius, grid_.sorted, s);
      for (std::size_t i = grid_.begin(cell); i < grid_.end(cell); ++i)
        kernels_.moments(s.list.points.view(), point(i).data(), squared(definition_.normal_radius),
                         &moments_[i], n_);
    });
    normals_.resize(n_);
    kernels_.plane_normals(moments_.data(), n_, grid_.sorted.view(), definition_.viewpoint.data(),
                           normals_.x.data(), normals_.y.data(), normals_.z.data());
  }

  /// Writes the normals by the cloud's rows, and moves the points without one far away, so that
  /// they are no neighbors in the descriptors.
  void write_normals() {
    oriented_ = grid_.sorted;
    for (std::size_t i = 0; i < n_; ++i) {
      float* out = &features_.normals[3 * static_cast<std::size_t>(grid_.rows[i])];
      out[0] = normals_.x[i];
      out[1] = normals_.y[i];
      out[2] = normals_.z[i];
      if (!has_normal(i)) oriented_.x[i] = oriented_.y[i] = oriented_.z[i] = kFarAway;
    }
  }

  void pair_histograms(std::size_t cell, Scratch& s) {
    gather(cell, definition_.feature_radius, oriented_, s);
    normals_.select(s.list.rows, s.normals);
    const SurfaceView list = {s.list.points.view(), s.normals.x.data(), s.normals.y.data(),
                              s.normals.z.data()};
    for (std::size_t i = grid_.begin(cell); i < grid_.end(cell); ++i) {
      if (!has_normal(i)) continue;
      const auto [x, y, z] = point(i);
      const SurfacePoint query = {{x, y, z}, {normals_.x[i], normals_.y[i], normals_.z[i]}};
      kernels_.pair_histograms(list, query, squared(definition_.feature_radius),
                               &histograms_[kDescriptorRow * i]);
    }
  }

  void weigh_histograms(std::size_t cell, Scratch& s) {
    gather(cell, definition_.feature_radius, oriented_, s);
    for (std::size_t i = grid_.begin(cell); i < grid_.end(cell); ++i) {
      if (!has_normal(i)) continue;
      std::array<float, kDescriptor> bins;
      kernels_.weighted_histograms(s.list.points.view(), s.list.rows.data(), point(i).data(),
                                   squared(definition_.feature_radius), histograms_.data(),
                                   bins.data());
      // A point alone in its neighborhood gets an empty histogram, which would match any other.
      float sum = 0;
      for (const float bin : bins) sum += bin;
      if (std::isfinite(sum) && sum > 0)
        std::copy(bins.begin(), bins.end(),
                  &features_.descriptors[kDescriptor * static_cast<std::size_t>(grid_.rows[i])]);
    }
  }

  static float squared(double radius) { return static_cast<float>(radius * radius); }

  const FeatureDefinition& definition_;
  const Kernels& kernels_;
  const Cloud& user_normals_;  // in the cloud's order; empty for none
  std::size_t n_;
  CellGrid grid_;
  std::vector<Scratch> scratch_;
  std::vector<float> moments_;  // of the sorted points, as all below; [moment][point]
  Cloud normals_, oriented_;
  std::vector<float> histograms_;
  Features features_;
};

}  // namespace

Features describe_by_kernels(const Cloud& cloud, const FeatureDefinition& definition,
                             const Kernels& kernels, int threads, const Cloud& normals) {
  Features out;
  Description description(cloud, definition, kernels, static_cast<std::size_t>(threads), normals);
  ThreadTeam::with(threads, [&](ThreadTeam& team) { out = description.run(team); });
  return out;
}

}  // namespace emtr
