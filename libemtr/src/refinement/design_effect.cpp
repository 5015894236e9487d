#include <algorithm>
#include <array>
#include <vector>

#include "refinement/local_refinement.h"
#include "refinement/plane_to_plane.h"
#include "voxels/voxel_order.h"

namespace emtr {
namespace {

/// Leaves: the cubes in which pairs are taken to say the same. Larger ones change little, until
/// there are too few of them.
constexpr double kCluster = 3;

using Gradient = std::array<double, 6>;  // g of one pair, see NormalEquations

double squared_length(const Gradient& g) {
  double sum = 0;
  for (const double x : g) sum += x * x;
  return sum;
}

/// Returns the sum of squares of the gradients summed in each cube.
double squared_by_cubes(const Cloud& places, const std::vector<Gradient>& gradients, double side) {
  double total = 0;
  const std::vector<VoxelRow> rows = rows_by_voxel(places, static_cast<float>(side));
  for (std::size_t i = 0; i < rows.size();) {
    Gradient sum{};
    for (const std::uint64_t cube = rows[i].voxel; i < rows.size() && rows[i].voxel == cube; ++i)
      for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += gradients[rows[i].row][k];
    total += squared_length(sum);
  }
  return total;
}

}  // namespace

double LocalRefinement::design_effect(const LocalRefinementResult& refined, Scratch& s) const {
  const State at{refined.pose, settings_.last_scale * leaf_, true};
  const PlaneToPlane estimator(at.pose, at.scale, settings_.softness, settings_.normal_gate);
  Cloud places;
  std::vector<Gradient> gradients;
  double pairs_squared = 0;
  const auto visit = [&](const SurfacePoint& source, const SurfacePoint& target) {
    Gradient gradient{};
    if (!estimator.gradient(source, target, gradient.data())) return;
    places.append(target.p[0], target.p[1], target.p[2]);
    gradients.push_back(gradient);
    pairs_squared += squared_length(gradient);
  };
  const auto visit_all = [&](bool reversed, const QueryPoints& queries) {
    matcher_.for_each_match(at.pose, reach(at), {reversed, 0, queries.size(), 0}, s.matches, visit);
  };
  visit_all(false, matcher_.source());
  if (settings_.both_ways) visit_all(true, matcher_.target());
  if (!(pairs_squared > 0)) return 1;
  return std::max(1.0, squared_by_cubes(places, gradients, kCluster * leaf_) / pairs_squared);
}

}  // namespace emtr
