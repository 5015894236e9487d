#include <algorithm>
#include <optional>
#include <utility>

#include "neighbors/kdtree_neighbors.h"
#include "pipeline/problem_stages.h"
#include "ranking/given_viewpoints.h"
#include "ranking/sampling_viewpoint.h"

namespace emtr {
namespace {

/// Makes the structure that the settings ask for. `leaf`: side of a grid's cells; `queries`: how
/// many it will have to answer, about.
std::unique_ptr<Neighbors> make_chosen_neighbors(const Settings& settings, const Cloud& cloud,
                                                 float radius, float leaf, double queries,
                                                 const Kernels& kernels) {
  if (settings.neighbors == NeighborStructure::KdTree) return make_kdtree(cloud, radius);
  if (settings.neighbors == NeighborStructure::BruteForce) return make_brute_force(cloud, radius);
  return make_neighbors(cloud, radius, leaf, queries, kernels);
}

/// The points in which the settings let the D stage look for neighbors.
TaskAlpha::DenseReferences dense_references(const Problem& problem) {
  constexpr double kSpacings = 2;
  const NormalizedPair& pair = problem.pair;
  if (problem.settings.dense_reference == DenseReference::Dense)
    return {problem.downsampled.source_dense, problem.downsampled.target_dense, 0};
  const double wider = std::max(spacing(*pair.preprocessed_source, pair.normalization),
                                spacing(*pair.preprocessed_target, pair.normalization));
  return {pair.source, pair.target, kSpacings * wider};
}

}  // namespace

void make_tasks(Problem& problem) {
  const Settings& settings = problem.settings;
  const DownsampledClouds& clouds = problem.downsampled;
  const auto make = [&](const Cloud& cloud, float radius, float leaf, std::size_t queries) {
    // Each structure serves about half of the iterations.
    const double all =
        0.5 * settings.population * settings.iterations * static_cast<double>(queries);
    return make_chosen_neighbors(settings, cloud, radius, leaf, all, problem.kernels);
  };
  problem.alpha = std::make_unique<TaskAlpha>(clouds, dense_references(problem), settings,
                                              problem.kernels, make);
  problem.beta = std::make_unique<TaskBeta>(problem.tims, problem.tau, settings, problem.kernels);
  // The complement reaches far: cells no finer than a share of that keep its structure small.
  const double reach = settings.complement_scale_start;
  auto far = make(clouds.target_sparse, static_cast<float>(reach),
                  static_cast<float>(std::max(1.5 * clouds.leaf_sparse, reach / 5)),
                  clouds.source_sparse.size());
  problem.complement = std::make_unique<KnowledgeComplement>(
      clouds.source_sparse, clouds.target_sparse, std::move(far), settings, problem.kernels);
}

void make_surfaces(Problem& problem) {
  if (problem.settings.candidates == 0) return;
  const DownsampledClouds& clouds = problem.downsampled;
  Surface source = surface(clouds.source_dense, problem.source_features, clouds.leaf_dense),
          target = surface(clouds.target_dense, problem.target_features, clouds.leaf_dense);
  source.weighted = target.weighted = problem.settings.distinctiveness != 0;
  const Normalization& n = problem.pair.normalization;
  const GivenViewpoints given(problem.settings, n);
  const auto viewpoint = [&](const std::optional<Viewpoint>& known, const Surface& of,
                             const Cloud& points, const double center[3]) {
    if (known || !problem.settings.free_space) return known;
    const double origin[3] = {-center[0] / n.scale, -center[1] / n.scale, -center[2] / n.scale};
    return std::optional<Viewpoint>(
        estimate_sampling_viewpoint(of, points, origin, problem.kernels));
  };
  const auto of_source = viewpoint(given.source, source, problem.pair.source, n.center_source),
             of_target = viewpoint(given.target, target, problem.pair.target, n.center_target);
  problem.surfaces = std::make_unique<SurfacePair>(std::move(source), std::move(target), of_source,
                                                   of_target, problem.kernels);
}

}  // namespace emtr
