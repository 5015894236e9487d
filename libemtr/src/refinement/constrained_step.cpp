#include "constrained_step.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <algorithm>

namespace emtr {
namespace {

constexpr int kMostChanges = 60;
constexpr double kRounding = 1e-13;

}  // namespace

Vector6 constrained_step(const Matrix6& H, const Vector6& g,
                         const std::vector<Prior::Limit>& limits) {
  const Eigen::LDLT<Matrix6> factor(H);
  const Vector6 free = -factor.solve(g);
  std::vector<std::size_t> active;
  for (std::size_t k = 0; k < limits.size(); ++k)
    if (limits[k].equality) active.push_back(k);
  const auto fixed = static_cast<Eigen::Index>(active.size());

  Vector6 x = free;
  for (int change = 0; change < kMostChanges; ++change) {
    const auto n = static_cast<Eigen::Index>(active.size());
    Eigen::MatrixXd J(n, 6);
    Eigen::VectorXd room(n), pull;
    for (Eigen::Index i = 0; i < n; ++i) {
      const Prior::Limit& limit = limits[active[static_cast<std::size_t>(i)]];
      J.row(i) = Vector6::Map(limit.J).transpose();
      room[i] = limit.equality ? 0 : limit.room;
    }
    x = free;
    if (n > 0) {
      const Eigen::MatrixXd HJ = factor.solve(J.transpose());
      pull = (J * HJ).completeOrthogonalDecomposition().solve(J * free - room);
      x -= HJ * pull;
    }
    // A limit that holds the step back from inside is none; then the one that is broken most.
    Eigen::Index loose = -1;
    for (Eigen::Index i = fixed; i < n; ++i)
      if (pull[i] < -kRounding && (loose < 0 || pull[i] < pull[loose])) loose = i;
    if (loose >= 0) {
      active.erase(active.begin() + loose);
      continue;
    }
    std::size_t worst = limits.size();
    double most = kRounding;
    for (std::size_t k = 0; k < limits.size(); ++k) {
      if (limits[k].equality) continue;
      const double over = Vector6::Map(limits[k].J).dot(x) - limits[k].room;
      const bool known = std::find(active.begin(), active.end(), k) != active.end();
      if (known || over <= most) continue;
      most = over;
      worst = k;
    }
    if (worst == limits.size()) break;
    active.push_back(worst);
  }
  return x;
}

}  // namespace emtr
