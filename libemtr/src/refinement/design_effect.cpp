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

/// The gradients of the pairs that one side's queries find, and where they are in the target.
struct Gradients {
  Cloud places;
  std::vector<Gradient> of_pairs;
};

/// Returns the sum of squares of the gradients summed in each cube.
double squared_by_cubes(const Gradients& gradients, double side) {
  double total = 0;
  const std::vector<VoxelRow> rows = rows_by_voxel(gradients.places, static_cast<float>(side));
  for (std::size_t i = 0; i < rows.size();) {
    Gradient sum{};
    for (const std::uint64_t cube = rows[i].voxel; i < rows.size() && rows[i].voxel == cube; ++i)
      for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += gradients.of_pairs[rows[i].row][k];
    total += squared_length(sum);
  }
  return total;
}

}  // namespace

double LocalRefinement::design_effect(const LocalRefinementResult& refined, Scratch& s,
                                      int threads) const {
  const State at{refined.pose, settings_.last_scale * leaf_, true};
  const PlaneToPlane estimator(at.pose, at.scale, settings_.softness, settings_.normal_gate);
  const std::size_t n = matcher_.source().size(), m = matcher_.target().size();
  s.matches.grow(n + m);
  Gradients by_side[2];
  parallel_for(settings_.both_ways ? 2 : 1, threads, [&](std::size_t i) {
    const bool reversed = i == 1;
    Gradients& found = by_side[i];
    matcher_.for_each_match(at.pose, reach(at), {reversed, 0, reversed ? m : n, reversed ? n : 0},
                            s.matches, [&](const SurfacePoint& source, const SurfacePoint& target) {
                              Gradient g;
                              if (!estimator.gradient(source, target, g.data())) return;
                              found.places.append(target.p[0], target.p[1], target.p[2]);
                              found.of_pairs.push_back(g);
                            });
  });
  Gradients& all = by_side[0];
  all.places.append(by_side[1].places);
  all.of_pairs.insert(all.of_pairs.end(), by_side[1].of_pairs.begin(), by_side[1].of_pairs.end());
  double pairs_squared = 0;
  for (const Gradient& g : all.of_pairs) pairs_squared += squared_length(g);
  if (!(pairs_squared > 0)) return 1;
  return std::max(1.0, squared_by_cubes(all, kCluster * leaf_) / pairs_squared);
}

}  // namespace emtr
