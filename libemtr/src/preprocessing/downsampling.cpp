#include "preprocessing/downsampling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <string>

#include "util/error.h"
#include "util/thread_team.h"
#include "voxels/voxel_counter.h"
#include "voxels/voxel_grid.h"
#include "voxels/voxel_order.h"

namespace emtr {
namespace {

constexpr double kFinestLeaf = 2e-3, kCoarsestLeaf = 1.0;

/// Returns the leaf between `finest` and kCoarsestLeaf whose count of points is nearest to
/// `wanted`, from a first guess. The count falls with the leaf but for jitter, so it keeps the best
/// leaf that it met.
double find_leaf(const std::function<std::size_t(float)>& count, double wanted, double finest,
                 double guess) {
  double low = std::log(finest), high = std::log(kCoarsestLeaf);
  double x = std::clamp(std::log(guess), low, high);
  double slope = -2;  // of log count over log leaf, as for a surface
  double best = finest, best_error = HUGE_VAL, last_x = 0, last_y = 0;
  bool finest_is_too_fine = false;
  for (int step = 0; step < 24; ++step) {
    check_cancelled();
    const double n = static_cast<double>(count(static_cast<float>(std::exp(x))));
    const double y = std::log(n), error = std::abs(n - wanted);
    if (error < best_error) {
      best_error = error;
      best = std::exp(x);
    }
    if (error <= 0.005 * wanted) break;
    if (n < wanted && x == low && !finest_is_too_fine) break;  // no finer leaf is allowed
    finest_is_too_fine |= n > wanted;
    (n > wanted ? low : high) = x;
    const double secant = step ? (y - last_y) / (x - last_x) : slope;
    if (secant > -4 && secant < -0.5) slope = secant;
    last_x = x;
    last_y = y;
    x += (std::log(wanted) - y) / slope;
    if (x <= low && !finest_is_too_fine)
      x = low;
    else if (!(x > low && x < high))
      x = (low + high) / 2;
  }
  return best;
}

/// Returns the finest useful leaf. Below about 1.5 point spacings a voxel holds single points, and
/// neither downsampling nor the neighborhoods of normals and features work. This matters only for
/// clouds of few points: the sparser one, however many points the other has.
double finest_leaf(const NormalizedPair& pair, const Settings& settings) {
  double spacings_of_few[2] = {0, 0};
  parallel_for(2, thread_count(settings), [&](std::size_t i) {
    const PreprocessedCloud& cloud = i == 0 ? *pair.preprocessed_source : *pair.preprocessed_target;
    if (cloud.base.size() <= 4 * static_cast<std::size_t>(settings.dense_points))
      spacings_of_few[i] = spacing(cloud, pair.normalization);
  });
  const double wider = std::max(spacings_of_few[0], spacings_of_few[1]);
  // Along an outline the nearest of two neighbors is much nearer than the other.
  const double spacings = settings.minimum_leaf_spacing * (pair.extruded ? 2 : 1);
  return std::clamp(spacings * wider, kFinestLeaf, kCoarsestLeaf / 2);
}

/// Throws Error when too few points are left: one leaf serves both clouds, so a cloud much smaller
/// than the other can vanish in a few voxels.
void require_enough_points(const Cloud& cloud, const char* name, double leaf, double scale) {
  constexpr std::size_t minimum = 10;  // a mere dot at the origin already fills 8 voxels
  if (cloud.size() >= minimum) return;
  throw Error(EMTR_ERROR_CLOUD,
              std::string(name) + " cloud: downsampled to " + std::to_string(cloud.size()) +
                  " points at the leaf that serves both clouds (" + std::to_string(leaf * scale) +
                  " in your unit), expected at least " + std::to_string(minimum) +
                  ": it has too few points, or is too small beside the other");
}

// In the memory of a cloud.
struct DenseCloud {
  Cloud points, normals;
};
struct SparseCloud {
  Cloud points;
};

/// Downsamples both clouds by one leaf; counts their voxels for the sparse and the dense pair.
class Downsampler {
 public:
  Downsampler(const NormalizedPair& pair, const Settings& settings)
      : pair_(pair),
        settings_(settings),
        threads_(thread_count(settings)),
        counters_{VoxelCounter(pair.source), VoxelCounter(pair.target)} {}

  void dense(DownsampledClouds& out) {
    // Two half balls of radius 1 have a surface of about 10.
    check_cancelled();
    const auto count = [&](float leaf) {
      std::size_t counts[2];
      parallel_for(2, threads_, [&](std::size_t i) { counts[i] = counters_[i](leaf); });
      return counts[0] + counts[1];
    };
    out.leaf_dense = find_leaf(count, settings_.dense_points, finest_leaf(pair_, settings_),
                               std::sqrt(10.0 / settings_.dense_points));
    out.leaf_dense = on_ladder(grown_leaf(out.leaf_dense));
    const auto both = downsample_both<DenseCloud>(
        out.leaf_dense, [](const Cloud& cloud, const Cloud& normals, float leaf) {
          return DenseCloud{voxel_grid(cloud, leaf),
                            normals.size() ? mean_normals(cloud, normals, leaf) : Cloud()};
        });
    out.source_dense = both[0]->points, out.source_normals = both[0]->normals;
    out.target_dense = both[1]->points, out.target_normals = both[1]->normals;

    require_enough_points(out.source_dense, "source", out.leaf_dense, pair_.normalization.scale);
    require_enough_points(out.target_dense, "target", out.leaf_dense, pair_.normalization.scale);
  }

  void sparse(DownsampledClouds& out) {
    // A cloud too coarse for the dense count keeps the ratio of sparse to dense, on which the
    // paper's saving rests.
    const double dense = static_cast<double>(out.source_dense.size() + out.target_dense.size());
    const double wanted = settings_.sparse_points * std::min(1.0, dense / settings_.dense_points);
    const double source_dense = static_cast<double>(out.source_dense.size());
    out.leaf_sparse =
        on_ladder(find_leaf([&](float leaf) { return counters_[0](leaf); }, wanted, out.leaf_dense,
                            out.leaf_dense * std::sqrt(source_dense / wanted)));
    const auto both = downsample_both<SparseCloud>(
        out.leaf_sparse, [](const Cloud& cloud, const Cloud&, float leaf) {
          return SparseCloud{voxel_grid(cloud, leaf)};
        });
    out.source_sparse = both[0]->points, out.target_sparse = both[1]->points;
  }

 private:
  /// Returns the leaf, larger where a cloud is not a surface at that scale but a set of curves: the
  /// rings of a spinning LiDAR, whose normals mean nothing and which lie best on the rings of the
  /// other scan, whatever the scene.
  double grown_leaf(double leaf) {
    constexpr double kStep = 1.189207115002721;  // the fourth root of 2
    const double largest = std::min(settings_.maximum_leaf_growth * leaf, kCoarsestLeaf);
    while (leaf * kStep <= largest) {
      bool along_curves[2];
      parallel_for(2, threads_, [&](std::size_t i) {
        along_curves[i] = lies_along_curves(static_cast<int>(i), leaf);
      });
      if (!along_curves[0] && !along_curves[1]) break;
      leaf *= kStep;
    }
    return leaf;
  }

  /// Tells by the dimension log2 N(l) / N(2 l) of a cloud at the leaf l, where N counts the
  /// occupied voxels: about 2 for a surface, 1 for curves. A cloud that is far less than a curve at
  /// half the leaf is just sparse. Few points along a ring make less than a curve too, but not far.
  bool lies_along_curves(int side, double leaf) {
    constexpr double kCurve = 1.414, kSurface = 2.64;  // 2^0.5, 2^1.4
    check_cancelled();
    const auto voxels = [&](double at) {
      return static_cast<double>(counters_[side](static_cast<float>(at)));
    };
    const double here = voxels(leaf);
    return voxels(leaf / 2) > kCurve * here && here < kSurface * voxels(2 * leaf);
  }

  double on_ladder(double leaf) const {
    // The rung nearest to the finest leaf must not be finer.
    return pair_.ladder ? Ladder::nearest(std::max(leaf, 1.05 * kFinestLeaf)) : leaf;
  }

  /// Calls make(points, normals, leaf) for each cloud of which its result is not known.
  template <class Downsampled, class Make>
  std::array<std::shared_ptr<const Downsampled>, 2> downsample_both(double leaf,
                                                                    const Make& make) const {
    std::array<std::shared_ptr<const Downsampled>, 2> out;
    parallel_for(2, threads_, [&](std::size_t i) {
      const int side = static_cast<int>(i);
      const Cloud& points = side == 0 ? pair_.source : pair_.target;
      const PreprocessedCloud& from =
          side == 0 ? *pair_.preprocessed_source : *pair_.preprocessed_target;
      out[i] = pair_.remembered<Downsampled>(
          side, {leaf}, [&] { return make(points, from.normals, static_cast<float>(leaf)); });
    });
    return out;
  }

  const NormalizedPair& pair_;
  const Settings& settings_;
  int threads_;
  VoxelCounter counters_[2];
};

}  // namespace

DownsampledClouds downsample(const NormalizedPair& pair, const Settings& settings) {
  DownsampledClouds out;
  Downsampler downsampler(pair, settings);
  downsampler.dense(out);
  downsampler.sparse(out);
  return out;
}

DownsampledClouds downsample_dense(const NormalizedPair& pair, const Settings& settings) {
  DownsampledClouds out;
  Downsampler(pair, settings).dense(out);
  return out;
}

}  // namespace emtr
