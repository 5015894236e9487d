#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/surface.h"
#include "ranking/direction_bins.h"

namespace emtr {

/// Counts what can be seen of a surface, from one viewpoint after another.
class ZBuffer {
 public:
  /// The surface (of at least one point) and the kernels must outlive this. `bin`: width of the
  /// bins in leaves, at the mean range. Narrow ones tell directions apart, wide ones leave no gaps
  /// for the far side of a closed model to be seen through.
  ZBuffer(const Surface& surface, double bin, const Kernels& kernels);

  const std::array<double, 3>& centroid() const { return centroid_; }

  /// Returns the share of the points that no other hides from the viewpoint, 0 to 1: none in the
  /// same bin of directions is nearer by more than a leaf and what the surface itself falls away in
  /// a bin.
  double visible_share(const double viewpoint[3]);

 private:
  void measure(const double viewpoint[3]);
  std::size_t find_bins(const DirectionBins& bins);  ///< returns how many bins there may be

  const Surface& surface_;
  double bin_width_;
  const Kernels& kernels_;
  std::array<double, 3> centroid_;
  std::vector<float> x_, y_, z_, range_, allowance_;
  std::vector<DirectionBins::Bin> place_;
  std::vector<std::uint32_t> bin_;
  std::vector<float> nearest_;  // by bin
};

}  // namespace emtr
