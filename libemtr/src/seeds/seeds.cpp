#include "seeds/seeds.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

#include "seeds/procrustes.h"
#include "seeds/support.h"
#include "util/thread_team.h"

namespace emtr {
namespace {

constexpr std::size_t kSubset = 12;  // correspondences beside the center of a seed
constexpr int kRefits = 2;

Eigen::Vector3d point(const Cloud& cloud, std::size_t i) {
  return {double{cloud.x[i]}, double{cloud.y[i]}, double{cloud.z[i]}};
}

/// Returns the correspondences with the most support first. Leaves out those within the threshold
/// of a taken one at both ends, which would give the same seed again.
std::vector<std::size_t> find_centers(const Consistency& c, double threshold, std::size_t max_count,
                                      ThreadTeam& team) {
  const std::vector<std::size_t> support = support_of_each(c, team);
  std::vector<std::size_t> order(c.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return support[a] > support[b]; });
  const auto near = [&](const Cloud& cloud, std::size_t i, std::size_t j) {
    const Eigen::Vector3d a = point(cloud, i), b = point(cloud, j);
    return std::hypot(a.x() - b.x(), a.y() - b.y(), a.z() - b.z()) < threshold;
  };
  std::vector<std::size_t> taken;
  for (const std::size_t i : order) {
    if (taken.size() == max_count || c.degree(i) < 2) break;
    check_cancelled();
    const bool duplicate = std::any_of(taken.begin(), taken.end(), [&](std::size_t j) {
      return near(c.p(), i, j) && near(c.q(), i, j);
    });
    if (!duplicate) taken.push_back(i);
  }
  return taken;
}

/// Makes the seed of a center.
class SeedFit {
 public:
  SeedFit(const Consistency& c, double threshold)
      : c_(c), squared_threshold_(threshold * threshold) {}

  Seed around(std::size_t center) const {
    Procrustes sums;
    for (const std::size_t i : consistent_subset(center)) add(sums, i);
    std::vector<std::uint64_t> inliers(c_.words()), others(c_.words());
    Seed best{sums.pose(), 0};
    best.inliers = c_.inliers(best.pose, squared_threshold_, inliers.data());
    for (int k = 0; k < kRefits && best.inliers >= 3; ++k) {
      const Rigid pose = fit(inliers);
      const std::size_t count = c_.inliers(pose, squared_threshold_, others.data());
      if (count <= best.inliers) break;
      best = {pose, count};
      inliers.swap(others);
    }
    return best;
  }

 private:
  std::vector<std::size_t> consistent_subset(std::size_t center) const {
    std::vector<std::pair<std::size_t, std::size_t>> consistent;  // how many in common, which
    c_.for_each_consistent(
        center, 0, [&](std::size_t j) { consistent.emplace_back(c_.common(center, j), j); });
    const std::size_t n = std::min(kSubset, consistent.size());
    std::partial_sort(consistent.begin(), consistent.begin() + static_cast<std::ptrdiff_t>(n),
                      consistent.end(), [](const auto& a, const auto& b) {
                        return a.first != b.first ? a.first > b.first : a.second < b.second;
                      });
    std::vector<std::size_t> out{center};
    for (std::size_t k = 0; k < n; ++k) out.push_back(consistent[k].second);
    return out;
  }

  void add(Procrustes& sums, std::size_t i) const { sums.add(point(c_.p(), i), point(c_.q(), i)); }

  Rigid fit(const std::vector<std::uint64_t>& set) const {
    Procrustes sums;
    for (std::size_t word = 0; word < set.size(); ++word)
      for (std::uint64_t bits = set[word]; bits; bits &= bits - 1)
        add(sums, 64 * word + static_cast<std::size_t>(__builtin_ctzll(bits)));
    return sums.pose();
  }

  const Consistency& c_;
  double squared_threshold_;
};

}  // namespace

std::vector<Seed> find_seeds(const Consistency& consistency, double threshold,
                             std::size_t max_count, int threads) {
  std::vector<Seed> seeds;
  ThreadTeam::with(threads, [&](ThreadTeam& team) {
    const std::vector<std::size_t> centers = find_centers(consistency, threshold, max_count, team);
    const SeedFit fit(consistency, threshold);
    seeds.resize(centers.size());
    team.parallel(centers.size(),
                  [&](std::size_t k, std::size_t) { seeds[k] = fit.around(centers[k]); });
  });
  std::stable_sort(seeds.begin(), seeds.end(),
                   [](const Seed& a, const Seed& b) { return a.inliers > b.inliers; });
  return seeds;
}

}  // namespace emtr
