#include "neighbors/flat_share.h"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "util/cancellation.h"

namespace emtr {
namespace {

constexpr std::size_t kLooks = 100, kNearest = 12;
constexpr std::size_t kCounts[] = {20000, 4000, 800, 200};
constexpr double kFlat = 0.05;  // smallest variance over the sum of the three

std::vector<std::size_t> evenly(std::size_t count, std::size_t most) {
  std::vector<std::size_t> rows(std::min(count, most));
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = i * count / rows.size();
  return rows;
}

/// Tells whether a point and its nearest are in one plane or on one line.
bool is_flat(const Cloud& cloud, std::size_t i) {
  std::vector<std::pair<float, std::size_t>> near(cloud.size());
  for (std::size_t j = 0; j < cloud.size(); ++j) {
    const float x = cloud.x[j] - cloud.x[i], y = cloud.y[j] - cloud.y[i],
                z = cloud.z[j] - cloud.z[i];
    near[j] = {(x * x + y * y) + z * z, j};
  }
  std::nth_element(near.begin(), near.begin() + kNearest, near.end());
  Eigen::Matrix<double, 3, kNearest + 1> points;
  for (std::size_t k = 0; k <= kNearest; ++k) {
    const std::size_t j = near[k].second;
    points.col(static_cast<Eigen::Index>(k)) << double{cloud.x[j]}, double{cloud.y[j]},
        double{cloud.z[j]};
  }
  points.colwise() -= points.rowwise().mean().eval();
  const Eigen::Matrix3d covariance = points * points.transpose();
  const Eigen::Vector3d variances =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance, Eigen::EigenvaluesOnly)
          .eigenvalues();
  return variances[0] <= kFlat * variances.sum();
}

/// Returns the share among so many points of the cloud.
double flat_share_among(const Cloud& cloud, std::size_t count) {
  const Cloud some = cloud.select(evenly(cloud.size(), count));
  if (some.size() <= kNearest) return 0;
  std::size_t flat = 0;
  const std::vector<std::size_t> looks = evenly(some.size(), kLooks);
  for (const std::size_t i : looks) {
    check_cancelled();
    flat += is_flat(some, i);
  }
  return static_cast<double>(flat) / static_cast<double>(looks.size());
}

}  // namespace

double flat_share(const Cloud& cloud) {
  double share = 0;
  for (const std::size_t count : kCounts)
    if (count == kCounts[0] || count < cloud.size())
      share = std::max(share, flat_share_among(cloud, count));
  return share;
}

}  // namespace emtr
