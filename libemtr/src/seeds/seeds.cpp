#include "seeds/seeds.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "util/thread_team.h"
#include "seeds/procrustes.h"

namespace emtr {
namespace {

constexpr std::size_t kSubset = 12;  // correspondences that speak for a seed
constexpr int kRefits = 2;

struct Point {
  double v[3];
};

Point at(const Cloud& cloud, std::size_t i) {
  return {{double{cloud.x[i]}, double{cloud.y[i]}, double{cloud.z[i]}}};
}

/// The correspondences with the most partners of their partners first; beside one that is taken,
/// those within the threshold at both ends would say the same again.
std::vector<std::size_t> centres(const Consistency& c, double threshold, std::size_t most,
                                 ThreadTeam& team) {
  std::vector<std::size_t> support(c.size()), order(c.size());
  team.parallel(c.size(), [&](std::size_t i, std::size_t) {
    std::size_t sum = 0;
    for (std::size_t j = 0; j < c.size(); ++j)
      if (c(i, j)) sum += c.common(i, j);
    support[i] = sum;
  });
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return support[a] > support[b]; });
  const auto near = [&](const Cloud& cloud, std::size_t i, std::size_t j) {
    const Point a = at(cloud, i), b = at(cloud, j);
    return std::hypot(a.v[0] - b.v[0], a.v[1] - b.v[1], a.v[2] - b.v[2]) < threshold;
  };
  std::vector<std::size_t> taken;
  for (const std::size_t i : order) {
    if (taken.size() == most || c.degree(i) < 2) break;
    check_cancelled();
    const bool copy = std::any_of(taken.begin(), taken.end(), [&](std::size_t j) {
      return near(c.p(), i, j) && near(c.q(), i, j);
    });
    if (!copy) taken.push_back(i);
  }
  return taken;
}

class SurfaceFit {
 public:
  SurfaceFit(const Consistency& c, double threshold) : c_(c), squared_(threshold * threshold) {}

  Seed around(std::size_t centre) const {
    const std::vector<std::size_t> subset = consistent_subset(centre);
    Procrustes sums;
    for (const std::size_t i : subset) add(sums, i);
    Seed best{sums.pose(), 0};
    best.inliers = inliers(best.pose, nullptr);
    for (int k = 0; k < kRefits; ++k) {
      Procrustes again;
      if (inliers(best.pose, &again) < 3) break;
      const Rigid pose = again.pose();
      const std::size_t count = inliers(pose, nullptr);
      if (count <= best.inliers) break;
      best = {pose, count};
    }
    return best;
  }

 private:
  std::vector<std::size_t> consistent_subset(std::size_t centre) const {
    std::vector<std::pair<std::size_t, std::size_t>> partners;  // shared partners, which
    for (std::size_t j = 0; j < c_.size(); ++j)
      if (c_(centre, j)) partners.emplace_back(c_.common(centre, j), j);
    const std::size_t n = std::min(kSubset, partners.size());
    std::partial_sort(partners.begin(), partners.begin() + static_cast<std::ptrdiff_t>(n),
                      partners.end(), [](const auto& a, const auto& b) {
                        return a.first != b.first ? a.first > b.first : a.second < b.second;
                      });
    std::vector<std::size_t> out{centre};
    for (std::size_t k = 0; k < n; ++k) out.push_back(partners[k].second);
    return out;
  }

  void add(Procrustes& sums, std::size_t i) const { sums.add(at(c_.p(), i).v, at(c_.q(), i).v); }

  std::size_t inliers(const Rigid& pose, Procrustes* sums) const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < c_.size(); ++i) {
      const Point p = at(c_.p(), i), q = at(c_.q(), i);
      const Eigen::Vector3d moved = pose * Eigen::Vector3d::Map(p.v);
      double squared = 0;
      for (int a = 0; a < 3; ++a) {
        const double d = moved[a] - q.v[a];
        squared += d * d;
      }
      if (squared >= squared_) continue;
      ++count;
      if (sums) add(*sums, i);
    }
    return count;
  }

  const Consistency& c_;
  double squared_;
};

}  // namespace

std::vector<Seed> find_seeds(const Consistency& consistency, double threshold, std::size_t most,
                             int threads) {
  std::vector<Seed> seeds;
  ThreadTeam::with(threads, [&](ThreadTeam& team) {
    const std::vector<std::size_t> chosen = centres(consistency, threshold, most, team);
    const SurfaceFit fit(consistency, threshold);
    seeds.resize(chosen.size());
    team.parallel(chosen.size(),
                  [&](std::size_t k, std::size_t) { seeds[k] = fit.around(chosen[k]); });
  });
  std::stable_sort(seeds.begin(), seeds.end(),
                   [](const Seed& a, const Seed& b) { return a.inliers > b.inliers; });
  return seeds;
}

}  // namespace emtr
