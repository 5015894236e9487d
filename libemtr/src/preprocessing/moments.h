#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

#include "preprocessing/cloud_reader.h"

namespace emtr {

struct Dispersion {
  double squared_radius = 0;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< times the number of points
};

/// The points of a reader, and how they lie about their centroid.
struct Moments {
  std::vector<std::size_t> finite;  ///< points of each block
  std::size_t count = 0;
  Eigen::Vector3d center = Eigen::Vector3d::Zero();  ///< centroid
  double unit = 1;                                   ///< of the dispersion, a power of two
  Dispersion dispersion;
};

[[noreturn]] void refuse_equal(const std::string& name);
[[noreturn]] void refuse_large(const std::string& name);

/// Measures the points in two passes. Throws Error, naming the cloud, when there are fewer than
/// `minimum`, all of them in one place, or coordinates too large to add.
Moments measure_moments(const CloudReader& reader, const std::string& name, int threads,
                        std::size_t minimum);

}  // namespace emtr
