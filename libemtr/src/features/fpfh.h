#pragma once

#include <limits>
#include <vector>

#include "../cloud.h"

namespace emtr {

constexpr int kFeatureSize = 33;  ///< bins of FPFH

/// Normals (n, 3) and FPFH descriptors (n, 33) of a cloud, row-major, NaN where a point has too
/// few neighbours for one.
struct Features {
  std::vector<float> normals;
  std::vector<float> descriptors;

  bool valid(std::size_t i) const {
    const float first = descriptors[i * kFeatureSize];
    return first == first;
  }
};

/// pcl::NormalEstimationOMP, oriented to the centroid (the origin of the normalised frame), and
/// pcl::FPFHEstimationOMP. Radii in the normalised frame.
Features describe(const Cloud& cloud, double normal_radius, double feature_radius, int threads);

}  // namespace emtr
