#pragma once

#include <Eigen/Core>

#include "geometry/rigid.h"
#include "ranking/surfaces.h"

namespace emtr_test {

/// Ground and four huts on it, of different sizes at irregular places: what stands in `low` < x <
/// `high`, every 0.03, moved by `phase` of that.
inline emtr::Surface yard(double low, double high, double phase) {
  constexpr double kStep = 0.03;
  struct Hut {
    double x, y, width, depth, height;
  };
  constexpr Hut huts[] = {{-0.5, -0.3, 0.3, 0.2, 0.3},
                          {-0.1, 0.35, 0.2, 0.4, 0.25},
                          {0.1, -0.4, 0.25, 0.15, 0.4},
                          {0.5, 0.2, 0.15, 0.3, 0.35}};
  emtr::Surface out;
  out.leaf = kStep;
  const auto add = [&](const Vector& p, const Vector& n) {
    if (p[0] > low && p[0] < high) push(out, p, n);
  };
  for (double x = -0.9 + phase * kStep; x < 0.9; x += kStep)
    for (double y = -0.7 + phase * kStep; y < 0.7; y += kStep) add({x, y, 0}, {0, 0, 1});
  for (const Hut& hut : huts)
    for (double z = phase * kStep; z < hut.height; z += kStep) {
      for (double x = phase * kStep; x < hut.width; x += kStep)
        for (const double y : {0.0, hut.depth}) add({hut.x + x, hut.y + y, z}, {0, 1, 0});
      for (double y = phase * kStep; y < hut.depth; y += kStep)
        for (const double x : {0.0, hut.width}) add({hut.x + x, hut.y + y, z}, {1, 0, 0});
    }
  return out;
}

}  // namespace emtr_test
