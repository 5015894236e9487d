#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "../surface.h"

namespace emtr {

/// Counts what can be seen of a surface, from one viewpoint after another.
class ZBuffer {
 public:
  /// The surface (of at least one point) and the kernels must outlive this.
  ZBuffer(const Surface& surface, const Kernels& kernels);

  const std::array<double, 3>& centroid() const { return centroid_; }

  /// Share of the points that no other hides from the viewpoint, 0 to 1: none in the same bin of
  /// directions, a leaf wide at the mean range, is nearer by more than a leaf, and by more than
  /// the surface itself falls away within the bin.
  double visible_share(const double viewpoint[3]);

 private:
  void measure(const double viewpoint[3]);

  const Surface& surface_;
  const Kernels& kernels_;
  std::array<double, 3> centroid_;
  std::vector<float> x_, y_, z_, range_, allowance_;
  std::vector<std::uint32_t> bin_;
  std::vector<float> nearest_;  // by bin
};

}  // namespace emtr
