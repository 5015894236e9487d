#include "preprocessing/extent.h"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "util/error.h"
#include "util/thread_team.h"

namespace emtr {
namespace {

void refuse_equal(const std::string& name) {
  throw Error(EMTR_ERROR_CLOUD, name + ": all points are equal, expected a radius above 1e-150");
}

void refuse_large(const std::string& name) {
  throw Error(EMTR_ERROR_CLOUD, name + ": coordinates too large, expected below 1e150");
}

Eigen::Vector3d first_finite(const CloudReader& reader) {
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < reader.count() && !reader.read(i, p.data()); ++i) {
  }
  return p;
}

struct Sum {
  std::size_t count = 0;
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();  // from the first finite point
  double farthest = 0;                               // largest difference of any coordinate
};

/// Sums relative to the first finite point, so that large coordinates keep their digits.
Sum sum_about(const Eigen::Vector3d& first, const CloudReader& reader, int threads,
              std::vector<std::size_t>& finite) {
  std::vector<Sum> sums(reader.blocks());
  parallel_for(sums.size(), threads, [&](std::size_t block) {
    Sum sum;
    reader.each_finite(block, [&](std::size_t, const double* p) {
      const Eigen::Vector3d offset = Eigen::Vector3d::Map(p) - first;
      sum.offset += offset;
      sum.farthest = std::max(sum.farthest, offset.cwiseAbs().maxCoeff());
      ++sum.count;
    });
    sums[block] = sum;
  });
  Sum total;
  finite.clear();
  for (const Sum& sum : sums) {
    total.count += sum.count;
    total.offset += sum.offset;
    total.farthest = std::max(total.farthest, sum.farthest);
    finite.push_back(sum.count);
  }
  return total;
}

struct Dispersion {
  double squared_radius = 0;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};

/// Measures the dispersion about the centroid, in a unit in which nothing overflows.
Dispersion dispersion_about(const Eigen::Vector3d& center, double unit, const CloudReader& reader,
                            int threads) {
  const double inverse = 1 / unit;
  std::vector<Dispersion> parts(reader.blocks());
  parallel_for(parts.size(), threads, [&](std::size_t block) {
    Dispersion part;
    reader.each_finite(block, [&](std::size_t, const double* p) {
      const Eigen::Vector3d u = (Eigen::Vector3d::Map(p) - center) * inverse;
      part.squared_radius = std::max(part.squared_radius, u.squaredNorm());
      part.covariance += u * u.transpose();
    });
    parts[block] = part;
  });
  Dispersion total;
  for (const Dispersion& part : parts) {
    total.squared_radius = std::max(total.squared_radius, part.squared_radius);
    total.covariance += part.covariance;
  }
  return total;
}

}  // namespace

Extent measure_extent(const CloudReader& reader, const std::string& name, int threads,
                      std::size_t minimum) {
  Extent extent;
  const Eigen::Vector3d first = first_finite(reader);
  const Sum sum = sum_about(first, reader, threads, extent.finite);
  extent.count = sum.count;
  if (sum.count < minimum)
    throw Error(EMTR_ERROR_CLOUD, name + ": " + std::to_string(sum.count) + " finite points of " +
                                      std::to_string(reader.count()) + ", expected at least " +
                                      std::to_string(minimum));
  const Eigen::Vector3d center = first + sum.offset / static_cast<double>(sum.count);
  if (!center.allFinite() || !std::isfinite(sum.farthest)) refuse_large(name);
  if (sum.farthest < 1e-151) refuse_equal(name);

  // A power of two, so that scaling by it costs no digits.
  const double unit = std::ldexp(1.0, std::ilogb(sum.farthest));
  const Dispersion dispersion = dispersion_about(center, unit, reader, threads);
  const double radius = unit * std::sqrt(dispersion.squared_radius);
  if (!std::isfinite(radius * radius)) refuse_large(name);
  // Rounding of large equal coordinates leaves a radius of a few units in their last place.
  if (!(radius > 1e-14 * center.cwiseAbs().maxCoeff()) || radius < 1e-150) refuse_equal(name);

  const Eigen::Vector3d variance =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(dispersion.covariance).eigenvalues();
  if (variance[1] <= 1e-12 * variance[2])
    throw Error(EMTR_ERROR_CLOUD, name + ": all points lie on one line, expected a surface");

  Eigen::Vector3d::Map(extent.center) = center;
  extent.radius = radius;
  dispersion.covariance.diagonal().maxCoeff(&extent.longest);
  return extent;
}

}  // namespace emtr
