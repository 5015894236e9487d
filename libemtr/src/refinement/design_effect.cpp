#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "refinement/local_refinement.h"
#include "refinement/plane_to_plane.h"

namespace emtr {
namespace {

/// Leaves: the cubes in which pairs are taken to say the same. Larger ones change little, until
/// there are too few of them.
constexpr double kCluster = 3;

double squared_length(const double g[6]) {
  double sum = 0;
  for (int k = 0; k < 6; ++k) sum += g[k] * g[k];
  return sum;
}

}  // namespace

double LocalRefinement::design_effect(const LocalRefinementResult& refined, Scratch& s) const {
  const State at{refined.pose, settings_.last_scale * leaf_, true};
  const PlaneToPlane estimator(at.pose, at.scale, settings_.softness, settings_.normal_gate);
  std::map<std::array<double, 3>, std::array<double, 6>> clusters;  // sums of g, by cube
  double pairs_squared = 0, clusters_squared = 0;
  const auto visit = [&](const SurfacePoint& source, const SurfacePoint& target) {
    NormalEquations one;
    estimator.add(source, target, one);
    std::array<double, 3> cube{};
    for (std::size_t a = 0; a < 3; ++a)
      cube[a] = std::floor(static_cast<double>(target.p[a]) / (kCluster * leaf_));
    std::array<double, 6>& sum = clusters[cube];
    for (std::size_t k = 0; k < 6; ++k) sum[k] += one.g[k];
    pairs_squared += squared_length(one.g);
  };
  const auto visit_all = [&](bool reversed, const QueryPoints& queries) {
    matcher_.for_each_match(at.pose, reach(at), {reversed, 0, queries.size(), 0}, s.matches, visit);
  };
  visit_all(false, matcher_.source());
  if (settings_.both_ways) visit_all(true, matcher_.target());
  for (const auto& [cube, sum] : clusters) clusters_squared += squared_length(sum.data());
  return pairs_squared > 0 ? std::max(1.0, clusters_squared / pairs_squared) : 1;
}

}  // namespace emtr
