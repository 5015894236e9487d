#pragma once

#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "refinement/fine_surfaces.h"
#include "refinement/shapes.h"

namespace emtr_test {

/// Points with a color each, as ColorReader reads them.
struct Painted {
  emtr::Cloud points, colors;
};

using Color = std::array<double, 3>;

/// Rectangles of random colors on a gray plane: what is at (x, y) within [-1.5, 1.5].
class Patches {
 public:
  explicit Patches(std::uint64_t seed, std::size_t count = 40) {
    Draw draw(seed);
    for (std::size_t i = 0; i < count; ++i)
      patches_.push_back({draw.uniform(-1.5, 1.5),
                          draw.uniform(-1.5, 1.5),
                          draw.uniform(0.04, 0.25),
                          draw.uniform(0.04, 0.25),
                          {draw.uniform(0, 1), draw.uniform(-1, 1), draw.uniform(-1, 1)}});
  }

  Color at(double x, double y) const {
    Color out = {0.8, 0, 0};
    for (const Patch& p : patches_)
      if (std::abs(x - p.x) < p.half_x && std::abs(y - p.y) < p.half_y) out = p.color;
    return out;
  }

 private:
  struct Patch {
    double x, y, half_x, half_y;
    Color color;
  };
  std::vector<Patch> patches_;
};

/// A painted plane z = 0 about (x, y) = (at, 0), with noise and an exposure of its own.
inline Painted painted_plane(const Patches& patches, std::uint64_t seed, double at = 0,
                             double gain = 1, double offset = 0, std::size_t n = 20000) {
  Draw draw(seed);
  Painted out;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = at + draw.uniform(-0.7, 0.7), y = draw.uniform(-0.7, 0.7);
    const Color color = patches.at(x, y);
    const double z = 0.001 * draw.gaussian();
    push(out.points, static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
    float shown[3];
    for (std::size_t k = 0; k < 3; ++k)
      shown[k] =
          static_cast<float>(gain * color[k] + (k == 0 ? offset : 0) + 0.02 * draw.gaussian());
    push(out.colors, shown[0], shown[1], shown[2]);
  }
  return out;
}

/// The cloud, moved.
inline emtr::Cloud moved_by(const emtr::Rigid& motion, const emtr::Cloud& cloud) {
  emtr::Cloud out;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3d p = motion * Eigen::Vector3d(cloud.x[i], cloud.y[i], cloud.z[i]);
    push(out, static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z()));
  }
  return out;
}

inline emtr::FineSurfaces fine_surfaces_of(const emtr::Cloud& source, const emtr::Cloud& target,
                                           double leaf) {
  emtr::NormalizedPair pair;
  pair.source = source;
  pair.target = target;
  return emtr::fine_surfaces(pair, leaf, 1, emtr::select_kernels());
}

}  // namespace emtr_test
