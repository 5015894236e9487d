#include "refinement/constrained_step.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <algorithm>
#include <limits>

namespace emtr {
namespace {

constexpr int kMaximumChanges = 100;
constexpr double kRounding = 1e-13;

/// The dual method of Goldfarb and Idnani (Mathematical Programming 27, 1983): limits that are
/// broken become active one after the other, and one that is active is dropped as soon as it would
/// keep the step from going further inside. The cost rises from change to change, so none comes
/// twice.
class ActiveSet {
 public:
  ActiveSet(const Matrix6& H, const Vector6& g, const std::vector<Prior::Limit>& limits)
      : limits_(limits), factor_(H), unconstrained_(-factor_.solve(g)) {
    for (std::size_t k = 0; k < limits.size(); ++k)
      if (limits[k].equality) active_.push_back(k);
    equalities_ = active_.size();
    multipliers_.assign(equalities_, 0);
  }

  Vector6 solve() {
    x_ = at_active();
    for (changes_ = 0; changes_ < kMaximumChanges;) {
      const std::size_t worst = worst_broken();
      if (worst == limits_.size()) break;
      if (!activate(worst)) break;
      x_ = at_active();  // free of the rounding of the steps on the way
    }
    return x_;
  }

 private:
  auto normal(std::size_t k) const { return Vector6::Map(limits_[k].J); }

  Eigen::MatrixXd normals() const {  // a column each
    Eigen::MatrixXd N(6, static_cast<Eigen::Index>(active_.size()));
    for (std::size_t i = 0; i < active_.size(); ++i)
      N.col(static_cast<Eigen::Index>(i)) = normal(active_[i]);
    return N;
  }

  /// Returns the best step with the active limits as equalities.
  Vector6 at_active() const {
    if (active_.empty()) return unconstrained_;
    const Eigen::MatrixXd N = normals(), HN = factor_.solve(N);
    Eigen::VectorXd room(N.cols());
    for (std::size_t i = 0; i < active_.size(); ++i)
      room[static_cast<Eigen::Index>(i)] = i < equalities_ ? 0 : limits_[active_[i]].room;
    const Eigen::MatrixXd S = N.transpose() * HN;
    return unconstrained_ -
           HN * S.completeOrthogonalDecomposition().solve(N.transpose() * unconstrained_ - room);
  }

  std::size_t worst_broken() const {
    std::size_t worst = limits_.size();
    double maximum = kRounding;
    for (std::size_t k = 0; k < limits_.size(); ++k) {
      const double over = normal(k).dot(x_) - limits_[k].room;
      const bool known = std::find(active_.begin(), active_.end(), k) != active_.end();
      if (limits_[k].equality || known || over <= maximum) continue;
      maximum = over;
      worst = k;
    }
    return worst;
  }

  /// Returns false when no step satisfies the limit together with those that cannot be dropped.
  bool activate(std::size_t limit) {
    const Vector6 n = normal(limit), Hn = factor_.solve(n);
    double multiplier = 0;
    while (++changes_ <= kMaximumChanges) {
      Vector6 along = Hn;      // the step goes against this direction
      Eigen::VectorXd relief;  // how fast the active limits' multipliers fall along it
      if (!active_.empty()) {
        const Eigen::MatrixXd N = normals(), HN = factor_.solve(N);
        const Eigen::MatrixXd S = N.transpose() * HN;
        relief = S.completeOrthogonalDecomposition().solve(N.transpose() * Hn);
        along -= HN * relief;
      }
      double longest = std::numeric_limits<double>::infinity();  // that keeps all multipliers
      std::size_t loose = active_.size();
      for (std::size_t i = equalities_; i < active_.size(); ++i) {
        const double less = relief[static_cast<Eigen::Index>(i)];
        if (less <= kRounding || multipliers_[i] / less >= longest) continue;
        longest = multipliers_[i] / less;
        loose = i;
      }
      const double gain = along.dot(n);
      const bool moves = gain > 1e-12 * Hn.dot(n);
      const double whole = (n.dot(x_) - limits_[limit].room) / gain;
      const bool done = moves && whole <= longest;
      if (!done && loose == active_.size()) return false;
      const double step = done ? whole : longest;
      if (moves) x_ -= step * along;
      for (std::size_t i = 0; i < active_.size(); ++i)
        multipliers_[i] -= step * relief[static_cast<Eigen::Index>(i)];
      multiplier += step;
      if (done) {
        active_.push_back(limit);
        multipliers_.push_back(multiplier);
        return true;
      }
      active_.erase(active_.begin() + static_cast<std::ptrdiff_t>(loose));
      multipliers_.erase(multipliers_.begin() + static_cast<std::ptrdiff_t>(loose));
    }
    return false;
  }

  const std::vector<Prior::Limit>& limits_;
  const Eigen::LDLT<Matrix6> factor_;
  const Vector6 unconstrained_;
  Vector6 x_;
  std::vector<std::size_t> active_;  // equalities first
  std::vector<double> multipliers_;  // of the active limits
  std::size_t equalities_ = 0;
  int changes_ = 0;
};

}  // namespace

Vector6 constrained_step(const Matrix6& H, const Vector6& g,
                         const std::vector<Prior::Limit>& limits) {
  return ActiveSet(H, g, limits).solve();
}

}  // namespace emtr
