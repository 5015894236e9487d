#include "ranking/sampling_viewpoint.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <unordered_map>
#include <vector>

#include "kernels/search_kernels.h"
#include "ranking/directions.h"
#include "util/cancellation.h"
#include "voxels/voxel_index.h"

namespace emtr {
namespace {

constexpr std::size_t kSamples = 1024;  // points of the surface that are looked at, about
constexpr double kNearRadii[] = {0.03, 0.06, 0.1, 0.16, 0.25, 0.4, 0.63, 1};
constexpr double kFarRadii[] = {1.26, 2.34, 4.33, 8};
constexpr std::size_t kNearDirections = 50, kFarDirections = 100;
constexpr int kFilterBits = 16;        // of the voxels that are looked for
constexpr double kFinestStep = 0.005;  // radii
// Scanners at the origin have this share of the best correlation there, and more; an origin that is
// elsewhere has below 0.8.
constexpr double kAsGood = 0.85;
constexpr double kNoTrust = 0.05, kFullTrust = 0.3;
constexpr double kClearlyBetter = 0.05;  // of a correlation, than from the other side

/// Returns the binary logarithm of a positive number to about 1e-4, as the kernels do it: the last
/// digits of a library's logarithm differ from machine to machine.
inline float approximate_log2(float v) {
  std::int32_t bits;
  std::memcpy(&bits, &v, sizeof bits);
  const auto exponent = static_cast<float>((bits >> 23) - 127);
  bits = (bits & 0x007fffff) | 0x3f800000;
  float m;
  std::memcpy(&m, &bits, sizeof m);  // 1 to 2
  // Least squares over that interval.
  return exponent +
         ((((-0.079158f * m + 0.628874f) * m + -2.081214f) * m + 4.028548f) * m + -2.496846f);
}

/// The sampled points with the logarithm of how many points of the cloud lie in their voxels.
class Sampling {
 public:
  Sampling(const Surface& surface, const Cloud& cloud, const Kernels& kernels)
      : kernels_(search_kernels(kernels)) {
    const std::vector<int> counts = count_points(surface, cloud);
    const std::size_t step = sample_step(surface);
    for (std::size_t i = 0, k = 0; i < surface.points.size(); i += step, ++k)
      if (counts[k] > 0 && std::isfinite(surface.normals.x[i]))
        add(surface, i, approximate_log2(static_cast<float>(counts[k])));
    center();
  }

  const Direction& centroid() const { return centroid_; }

  /// Correlates the sampling with what a scanner at this place would have made; 0 when either does
  /// not vary.
  double correlation(const double at[3]) const {
    const float place[3] = {static_cast<float>(at[0]), static_cast<float>(at[1]),
                            static_cast<float>(at[2])};
    double sums[3];
    kernels_.sampling_sums({x_.data(), y_.data(), z_.data(), nx_.data(), ny_.data(), nz_.data(),
                            log_count_.data(), present_.data(), x_.size()},
                           place, sums);
    const auto [sum, squares, products] = sums;
    const double n = static_cast<double>(size_), variance = squares - sum * sum / n;
    return variance > 0 && variance_ > 0 ? products / std::sqrt(variance * variance_) : 0;
  }

 private:
  static std::size_t sample_step(const Surface& surface) {
    return std::max<std::size_t>(1, surface.points.size() / kSamples);
  }

  /// Counts the cloud's points in the voxels of the sampled points.
  static std::vector<int> count_points(const Surface& surface, const Cloud& cloud) {
    const float inverse = 1 / static_cast<float>(surface.leaf);
    const auto key = [inverse](const Cloud& c, std::size_t i) {
      const auto index = [inverse](float v) {
        return static_cast<std::uint64_t>(std::int64_t{voxel_index(v, inverse)} + (1 << 20));
      };
      return index(c.x[i]) << 42 | index(c.y[i]) << 21 | index(c.z[i]);
    };
    const std::size_t step = sample_step(surface);
    std::unordered_map<std::uint64_t, int> voxels;
    std::vector<bool> perhaps(std::size_t{1} << kFilterBits);  // by a hash; most points are in none
    const auto hash = [](std::uint64_t k) { return k * 0x9e3779b97f4a7c15 >> (64 - kFilterBits); };
    for (std::size_t i = 0; i < surface.points.size(); i += step) {
      const std::uint64_t k = key(surface.points, i);
      voxels[k];
      perhaps[hash(k)] = true;
    }
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      const std::uint64_t k = key(cloud, i);
      if (!perhaps[hash(k)]) continue;
      const auto found = voxels.find(k);
      if (found != voxels.end()) ++found->second;
    }
    std::vector<int> counts;
    for (std::size_t i = 0; i < surface.points.size(); i += step)
      counts.push_back(voxels[key(surface.points, i)]);
    return counts;
  }

  void add(const Surface& s, std::size_t i, float log_count) {
    x_.push_back(s.points.x[i]);
    y_.push_back(s.points.y[i]);
    z_.push_back(s.points.z[i]);
    nx_.push_back(s.normals.x[i]);
    ny_.push_back(s.normals.y[i]);
    nz_.push_back(s.normals.z[i]);
    log_count_.push_back(log_count);
    present_.push_back(1);
  }

  /// Takes the mean off the logarithms, and fills the last lanes.
  void center() {
    size_ = x_.size();
    double mean = 0;
    for (const float c : log_count_) mean += static_cast<double>(c);
    for (std::size_t i = 0; i < size_; ++i) {
      centroid_[0] += static_cast<double>(x_[i]);
      centroid_[1] += static_cast<double>(y_[i]);
      centroid_[2] += static_cast<double>(z_[i]);
    }
    if (size_ == 0) return;
    for (double& c : centroid_) c /= static_cast<double>(size_);
    mean /= static_cast<double>(size_);
    for (float& c : log_count_) {
      c -= static_cast<float>(mean);
      variance_ += static_cast<double>(c) * static_cast<double>(c);
    }
    while (x_.size() % kLanes)
      for (auto* v : {&x_, &y_, &z_, &nx_, &ny_, &nz_, &log_count_, &present_}) v->push_back(0);
  }

  const SearchKernels& kernels_;
  std::vector<float> x_, y_, z_, nx_, ny_, nz_, log_count_, present_;
  std::size_t size_ = 0;
  double variance_ = 0;
  Direction centroid_{};
};

/// The best place so far.
struct Best {
  const Sampling& sampling;
  Direction at{};
  double correlation = -1;

  bool look(const Direction& place) {
    const double value = sampling.correlation(place.data());
    if (value <= correlation) return false;
    at = place;
    correlation = value;
    return true;
  }
};

void look_around(Best& best, std::size_t directions, double radius) {
  check_cancelled();
  const Direction& c = best.sampling.centroid();
  for (const Direction& d : spread_directions(directions))
    best.look({c[0] + radius * d[0], c[1] + radius * d[1], c[2] + radius * d[2]});
}

/// Steps along the axes for as long as that helps, by smaller and smaller steps.
void improve(Best& best) {
  const Direction& c = best.sampling.centroid();
  const double dx = best.at[0] - c[0], dy = best.at[1] - c[1], dz = best.at[2] - c[2];
  const double range = std::sqrt(dx * dx + dy * dy + dz * dz);
  double step = 0.3 * std::max(range, 0.05);
  while (step > kFinestStep) {
    for (int round = 0; round < 3; ++round) {
      bool better = false;
      for (std::size_t axis = 0; axis < 3; ++axis)
        for (const double move : {-step, step}) {
          Direction place = best.at;
          place[axis] += move;
          better |= best.look(place);
        }
      if (!better) break;
    }
    step /= 2;
  }
}

/// Returns how far a place outside of the cloud is to be believed and not the one behind it, which
/// sees a thin sheet under the same angles: 0 to 1.
double trust_in_side(const Best& best) {
  const Direction& c = best.sampling.centroid();
  Direction behind;
  double squared = 0;
  for (std::size_t a = 0; a < 3; ++a) {
    behind[a] = 2 * c[a] - best.at[a];
    squared += (best.at[a] - c[a]) * (best.at[a] - c[a]);
  }
  if (squared < 1) return 1;
  const double margin = best.correlation - best.sampling.correlation(behind.data());
  return std::clamp(margin / kClearlyBetter, 0.0, 1.0);
}

}  // namespace

Viewpoint estimate_sampling_viewpoint(const Surface& surface, const Cloud& cloud,
                                      const double origin[3], const Kernels& kernels) {
  const Sampling sampling(surface, cloud, kernels);
  Best best{sampling};
  best.look(sampling.centroid());
  for (const double radius : kNearRadii) look_around(best, kNearDirections, radius);
  for (const double radius : kFarRadii) look_around(best, kFarDirections, radius);
  improve(best);
  const double from_origin = sampling.correlation(origin);
  if (from_origin > kAsGood * best.correlation) {
    std::copy_n(origin, 3, best.at.begin());
    best.correlation = from_origin;
  }

  Viewpoint out;
  std::copy(best.at.begin(), best.at.end(), out.at);
  out.trust = std::clamp((best.correlation - kNoTrust) / (kFullTrust - kNoTrust), 0.0, 1.0);
  out.trust *= trust_in_side(best);
  out.given = false;
  return out;
}

}  // namespace emtr
