#include "seeds/triangles.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>
#include <utility>

#include "correspondences/match_points.h"
#include "seeds/procrustes.h"
#include "util/cancellation.h"

namespace emtr {
namespace {

constexpr std::size_t kKept = 24;
constexpr std::size_t kMost = 400000;  // triangles that are counted, some 10 ms of work
constexpr std::size_t kFit = 10;       // a fit takes as long as so many, and one more a match
constexpr double kThin = 0.02;         // sine of a corner of a triangle that gives no rotation

using Rows = std::vector<std::uint32_t>;

/// Finds the axes of a triangle: along its first side, in its plane, along its normal. Returns
/// false when its corners are near one line.
bool find_axes(const Eigen::Vector3d (&at)[3], Eigen::Matrix3d& axes) {
  const Eigen::Vector3d u = at[1] - at[0], v = at[2] - at[0], n = u.cross(v);
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
  const double length = distance(n, zero);
  if (!(length > kThin * distance(u, zero) * distance(v, zero))) return false;
  axes.col(0) = u / distance(u, zero);
  axes.col(2) = n / length;
  axes.col(1) = axes.col(2).cross(axes.col(0));
  return true;
}

class Search {
 public:
  Search(const Consistency& consistency, double reach, std::size_t least)
      : c_(consistency), reach_(reach), least_(least), later_(c_.words(), ~std::uint64_t{0}) {}

  std::vector<Triangle> run(const std::function<bool(const Triangle&)>& is_enough) {
    Rows order(c_.size());
    std::iota(order.begin(), order.end(), std::uint32_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return c_.degree(a) > c_.degree(b); });
    std::size_t asked = 2;
    for (const std::uint32_t i : order) {
      check_cancelled();
      clear(later_, i);
      if (c_.degree(i) + 1 < least_) continue;
      open_ = both(c_.row(i), later_.data());
      for (const std::uint32_t j : sides(i)) {
        clear(open_, j);
        visit(i, j);
        if (counted_ > kMost) return best_;
        if (best_.empty() || 2 * best_.front().matches.size() < 3 * asked) continue;
        asked = best_.front().matches.size();
        if (is_enough(best_.front())) return best_;
      }
    }
    return best_;
  }

 private:
  static void clear(std::vector<std::uint64_t>& bits, std::size_t i) {
    bits[i / 64] &= ~(std::uint64_t{1} << (i % 64));
  }
  template <class Visit>
  static void each_bit(const std::vector<std::uint64_t>& bits, const Visit& visit) {
    for (std::size_t w = 0; w < bits.size(); ++w)
      for (std::uint64_t left = bits[w]; left; left &= left - 1)
        visit(static_cast<std::uint32_t>(64 * w) +
              static_cast<std::uint32_t>(__builtin_ctzll(left)));
  }
  std::vector<std::uint64_t> both(const std::uint64_t* a, const std::uint64_t* b) const {
    std::vector<std::uint64_t> out(c_.words());
    for (std::size_t w = 0; w < out.size(); ++w) out[w] = a[w] & b[w];
    return out;
  }

  /// Returns the second corners, those with the most in common first.
  Rows sides(std::uint32_t i) const {
    std::vector<std::pair<std::size_t, std::uint32_t>> found;
    each_bit(open_, [&](std::uint32_t j) {
      const std::size_t common = c_.common(i, j);
      if (common >= 1 && common + 2 >= least_) found.emplace_back(common, j);
    });
    std::stable_sort(found.begin(), found.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    Rows out;
    for (const auto& side : found) out.push_back(side.second);
    return out;
  }

  /// Looks at the triangles of one side that have not been looked at from another.
  void visit(std::uint32_t i, std::uint32_t j) {
    const std::vector<std::uint64_t> common = both(c_.row(i), c_.row(j));
    each_bit(both(common.data(), open_.data()), [&](std::uint32_t k) {
      ++counted_;
      const std::size_t others = c_.count_common(common.data(), k);
      if (others + 3 < least_) return;
      counted_ += kFit + others;
      add({i, j, k}, both(common.data(), c_.row(k)));
    });
  }

  void add(const Rows& corners, const std::vector<std::uint64_t>& common) {
    Procrustes sums;
    for (const std::uint32_t i : corners) add(sums, i);
    const Rigid pose = pose_of(corners, sums);
    Triangle found{pose, corners};
    each_bit(common, [&](std::uint32_t l) {
      if (distance(pose * point_of(c_.p(), l), point_of(c_.q(), l)) >= reach_) return;
      found.matches.push_back(l);
      add(sums, l);
    });
    if (found.matches.size() < least_) return;
    const auto inside = [&](const Triangle& other) {
      return other.matches.size() >= found.matches.size() &&
             std::all_of(corners.begin(), corners.end(), [&](std::uint32_t i) {
               return std::find(other.matches.begin(), other.matches.end(), i) !=
                      other.matches.end();
             });
    };
    if (std::any_of(best_.begin(), best_.end(), inside)) return;
    found.pose = sums.pose();
    keep(std::move(found));
  }

  void keep(Triangle found) {
    const auto place = std::find_if(best_.begin(), best_.end(), [&](const Triangle& other) {
      return other.matches.size() < found.matches.size();
    });
    best_.insert(place, std::move(found));
    if (best_.size() > kKept) best_.pop_back();
    // By chance a wrong triangle can be a little larger than the right one.
    least_ = std::max(least_, best_.front().matches.size() * 3 / 4);
    if (best_.size() == kKept) least_ = std::max(least_, best_.back().matches.size() + 1);
  }

  /// Returns the pose of three matches; of three near one line any that fits.
  Rigid pose_of(const Rows& corners, const Procrustes& sums) const {
    Eigen::Vector3d p[3], q[3];
    for (std::size_t k = 0; k < 3; ++k) {
      p[k] = point_of(c_.p(), corners[k]);
      q[k] = point_of(c_.q(), corners[k]);
    }
    Eigen::Matrix3d from, to;
    if (!find_axes(p, from) || !find_axes(q, to)) return sums.pose();
    Rigid out;
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b)
        out.R(a, b) = (to(a, 0) * from(b, 0) + to(a, 1) * from(b, 1)) + to(a, 2) * from(b, 2);
    out.t = (q[0] + q[1] + q[2]) / 3 - out.rotate((p[0] + p[1] + p[2]) / 3);
    return out;
  }

  void add(Procrustes& sums, std::uint32_t i) const {
    sums.add(point_of(c_.p(), i), point_of(c_.q(), i));
  }

  const Consistency& c_;
  const double reach_;
  std::size_t least_, counted_ = 0;
  std::vector<std::uint64_t> later_;  // matches that have not been the first corner
  std::vector<std::uint64_t> open_;   // of those, consistent with the first and not yet the second
  std::vector<Triangle> best_;
};

}  // namespace

std::vector<Triangle> find_triangles(const Consistency& consistency, double reach,
                                     std::size_t least,
                                     const std::function<bool(const Triangle&)>& is_enough) {
  return Search(consistency, reach, std::max<std::size_t>(least, 3)).run(is_enough);
}

}  // namespace emtr
