#include "preprocessing/extent.h"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <cmath>

#include "preprocessing/moments.h"
#include "preprocessing/strays.h"
#include "util/error.h"
#include "util/thread_team.h"

namespace emtr {
namespace {

constexpr int kRounds = 8;  // strays of ever smaller distances

DistanceHistogram distances_from(const Ball& center, const CloudReader& reader, int threads) {
  std::vector<DistanceHistogram> parts(reader.blocks());
  parallel_for(parts.size(), threads, [&](std::size_t block) {
    reader.each_finite(
        block, [&](std::size_t, const double* p) { parts[block].add(center.squared_distance(p)); });
  });
  DistanceHistogram total;
  for (const DistanceHistogram& part : parts) total.add(part);
  return total;
}

/// Returns the ball in which all points lie but those that are strays, at most `most`.
std::optional<Ball> ball_without_strays(const Moments& moments, std::size_t most,
                                        const CloudReader& reader, int threads) {
  const Dispersion& dispersion = moments.dispersion;
  const double mean = dispersion.covariance.trace() / static_cast<double>(moments.count);
  if (!may_have_strays(dispersion.squared_radius, mean)) return std::nullopt;
  Ball ball;
  Eigen::Vector3d::Map(ball.center) = moments.center;
  ball.inverse_unit = 1 / moments.unit;
  const auto from = distances_from(ball, reader, threads).find_strays(most);
  if (!from) return std::nullopt;
  ball.squared_radius = *from;
  return ball;
}

}  // namespace

Extent measure_extent(const CloudReader& all, const std::string& name, int threads,
                      std::size_t minimum) {
  Extent extent;
  CloudReader reader = all;
  Moments moments = measure_moments(reader, name, threads, minimum);
  const std::size_t points = moments.count, most = most_strays(points);
  for (int round = 0; round < kRounds; ++round) {
    const auto ball = ball_without_strays(moments, most - extent.strays, reader, threads);
    if (!ball) break;
    reader.keep_within(*ball);
    moments = measure_moments(reader, name, threads, minimum);
    extent.without_strays = ball;
    extent.strays = points - moments.count;
  }
  extent.count = moments.count;
  extent.finite = moments.finite;

  const double radius = moments.unit * std::sqrt(moments.dispersion.squared_radius);
  if (!std::isfinite(radius * radius)) refuse_large(name);
  // Rounding of large equal coordinates leaves a radius of a few units in their last place.
  if (!(radius > 1e-14 * moments.center.cwiseAbs().maxCoeff()) || radius < 1e-150)
    refuse_equal(name);

  const Eigen::Matrix3d& covariance = moments.dispersion.covariance;
  const Eigen::Vector3d variance =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvalues();
  if (variance[1] <= 1e-12 * variance[2])
    throw Error(EMTR_ERROR_CLOUD, name + ": all points lie on one line, expected a surface");

  Eigen::Vector3d::Map(extent.center) = moments.center;
  extent.radius = radius;
  covariance.diagonal().maxCoeff(&extent.longest);
  return extent;
}

}  // namespace emtr
