#pragma once

#include <emtr/emtr.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace emtr_test {

/// Two overlapping parts of one sampled relief, the source rotated by 120 degrees about (1, 1, 1)
/// and translated, with what is otherwise unknown: normals, and which rows are the same point.
struct KnownPair {
  std::vector<float> source, target, source_normals, target_normals;  ///< packed
  std::vector<std::pair<std::int32_t, std::int32_t>> matches;         ///< by rows of the source

  explicit KnownPair(std::size_t points, unsigned seed = 1) {
    std::mt19937 random(seed);
    const auto draw = [&] { return static_cast<double>(random()) / 2147483648.0 - 1; };
    for (std::size_t i = 0; i < points; ++i) {
      const double u = draw(), v = draw(), a = 3 * u + v,
                   bump = 0.2 * std::exp(-8 * ((u - 0.3) * (u - 0.3) + v * v));
      const double p[3] = {u, v, 0.3 * std::sin(a) * std::cos(2 * v) + bump};
      const double du = 0.9 * std::cos(a) * std::cos(2 * v) - 16 * (u - 0.3) * bump,
                   dv = 0.3 * std::cos(a) * std::cos(2 * v) - 0.6 * std::sin(a) * std::sin(2 * v) -
                        16 * v * bump,
                   length = std::sqrt(du * du + dv * dv + 1);
      const double n[3] = {-du / length, -dv / length, 1 / length};
      const bool in_source = u > -0.5, in_target = u < 0.6;
      if (in_source && in_target)
        matches.emplace_back(static_cast<std::int32_t>(source.size() / 3),
                             static_cast<std::int32_t>(target.size() / 3));
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t from = (k + 1) % 3;  // the source's axes are y, z, x of the target's
        if (in_source) {
          source.push_back(static_cast<float>(p[from] + 4));
          source_normals.push_back(static_cast<float>(n[from]));
        }
        if (in_target) {
          target.push_back(static_cast<float>(p[k]));
          target_normals.push_back(static_cast<float>(n[k]));
        }
      }
    }
  }

  emtr_cloud source_cloud() const { return {source.data(), source.size() / 3, 0, EMTR_FLOAT32}; }
  emtr_cloud target_cloud() const { return {target.data(), target.size() / 3, 0, EMTR_FLOAT32}; }

  /// The largest difference of an entry from the true pose.
  static double error(const double T[16]) {
    const double truth[16] = {0, 0, 1, -4, 1, 0, 0, -4, 0, 1, 0, -4, 0, 0, 0, 1};
    double most = 0;
    for (int i = 0; i < 16; ++i) most = std::fmax(most, std::abs(T[i] - truth[i]));
    return std::isfinite(T[0]) ? most : HUGE_VAL;
  }

  /// Makes `count` matches spread over all rows; all but each `right`-th are wrong at random.
  std::vector<std::int32_t> correspondences(std::size_t count, std::size_t right) const {
    std::mt19937 random(5);
    std::vector<std::int32_t> out;
    for (std::size_t i = 0; i < count; ++i) {
      auto [s, t] = matches[i * matches.size() / count];
      if (i % right) t = static_cast<std::int32_t>(random() % (target.size() / 3));
      out.insert(out.end(), {s, t});
    }
    return out;
  }
};

}  // namespace emtr_test
