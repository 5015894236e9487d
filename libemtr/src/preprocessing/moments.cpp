#include "preprocessing/moments.h"

#include <algorithm>
#include <cmath>

#include "util/error.h"
#include "util/thread_team.h"

namespace emtr {
namespace {

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

/// Measures the dispersion about the centroid, in a unit in which nothing overflows.
Dispersion dispersion_about(const Eigen::Vector3d& center, double unit, const CloudReader& reader,
                            int threads) {
  const double inverse = 1 / unit;
  std::vector<Dispersion> parts(reader.blocks());
  parallel_for(parts.size(), threads, [&](std::size_t block) {
    // Plain numbers, which stay in registers.
    double squared_radius = 0, xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
    reader.each_finite(block, [&](std::size_t, const double* p) {
      const Eigen::Vector3d u = (Eigen::Vector3d::Map(p) - center) * inverse;
      squared_radius = std::max(squared_radius, u.squaredNorm());
      xx += u.x() * u.x(), xy += u.x() * u.y(), xz += u.x() * u.z();
      yy += u.y() * u.y(), yz += u.y() * u.z(), zz += u.z() * u.z();
    });
    parts[block].squared_radius = squared_radius;
    parts[block].covariance << xx, xy, xz, xy, yy, yz, xz, yz, zz;
  });
  Dispersion total;
  for (const Dispersion& part : parts) {
    total.squared_radius = std::max(total.squared_radius, part.squared_radius);
    total.covariance += part.covariance;
  }
  return total;
}

}  // namespace

void refuse_equal(const std::string& name) {
  throw Error(EMTR_ERROR_CLOUD, name + ": all points are equal, expected a radius above 1e-150");
}

void refuse_large(const std::string& name) {
  throw Error(EMTR_ERROR_CLOUD, name + ": coordinates too large, expected below 1e150");
}

Moments measure_moments(const CloudReader& reader, const std::string& name, int threads,
                        std::size_t minimum) {
  Moments out;
  const Eigen::Vector3d first = first_finite(reader);
  const Sum sum = sum_about(first, reader, threads, out.finite);
  out.count = sum.count;
  if (sum.count < minimum)
    throw Error(EMTR_ERROR_CLOUD, name + ": " + std::to_string(sum.count) + " finite points of " +
                                      std::to_string(reader.count()) + ", expected at least " +
                                      std::to_string(minimum));
  out.center = first + sum.offset / static_cast<double>(sum.count);
  if (!out.center.allFinite() || !std::isfinite(sum.farthest)) refuse_large(name);
  if (sum.farthest < 1e-151) refuse_equal(name);

  // A power of two, so that scaling by it costs no digits.
  out.unit = std::ldexp(1.0, std::ilogb(sum.farthest));
  out.dispersion = dispersion_about(out.center, out.unit, reader, threads);
  return out;
}

}  // namespace emtr
