#include <algorithm>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "evolution/engine.h"
#include "neighbors/kdtree_neighbors.h"
#include "pipeline/problem_stages.h"
#include "ranking/given_viewpoints.h"
#include "ranking/sampling_viewpoint.h"
#include "settings/choices.h"
#include "util/thread_team.h"

namespace emtr {
namespace {

/// Makes the structure that the settings ask for. `queries`: how many it will have to answer,
/// about.
std::unique_ptr<Neighbors> make_chosen_neighbors(const Settings& settings, const Cloud& cloud,
                                                 float radius, double queries,
                                                 const Kernels& kernels) {
  if (settings.neighbors == NeighborStructure::KdTree) return make_kdtree(cloud, radius);
  if (settings.neighbors == NeighborStructure::BruteForce) return make_brute_force(cloud, radius);
  return make_neighbors(cloud, radius, queries, kernels);
}

/// Returns about how many iterations look for neighbors at a resolution.
double expected_iterations(const Settings& settings, Stages stages, emtr_resolution resolution) {
  constexpr double kGoesOn = 0.1;  // share of the runs that do not stall before the D stage
  const double half = 0.5 * settings.iterations;
  if (stages == Stages::All || settings.seeds == 0 || !may_stall(settings)) return half;
  const bool first = resolution == EMTR_RESOLUTION_SPARSE || !settings.sparse_to_dense;
  return first ? std::min(half, settings.stall_iterations + 2.0) : kGoesOn * half;
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

void make_tasks(Problem& problem, Stages stages) {
  const Settings& settings = problem.settings;
  const DownsampledClouds& clouds = problem.downsampled;
  const auto make = [&](const Cloud& cloud, float radius, std::size_t queries,
                        emtr_resolution resolution) {
    const double all = settings.population * static_cast<double>(queries) *
                       expected_iterations(settings, stages, resolution);
    return make_chosen_neighbors(settings, cloud, radius, all, problem.kernels);
  };
  problem.alpha = std::make_unique<TaskAlpha>(clouds, dense_references(problem), settings,
                                              problem.kernels, make);
  problem.beta = std::make_unique<TaskBeta>(problem.tims, problem.tau, settings, problem.kernels);
  auto far = make(clouds.target_sparse, static_cast<float>(settings.complement_scale_start),
                  clouds.source_sparse.size(), EMTR_RESOLUTION_SPARSE);
  problem.complement = std::make_unique<KnowledgeComplement>(
      clouds.source_sparse, clouds.target_sparse, std::move(far), settings, problem.kernels);
}

/// Returns the surface of one side's dense cloud, from the memory of that cloud where it is known.
SharedSurface surface_of(int side, const Problem& problem) {
  const DownsampledClouds& clouds = problem.downsampled;
  const bool weighted = problem.settings.distinctiveness != 0;
  std::vector<double> by = problem.features_by[side];
  by.push_back(weighted);
  return *problem.pair.remembered<SharedSurface>(side, by, [&] {
    Surface out =
        surface(side == 0 ? clouds.source_dense : clouds.target_dense,
                side == 0 ? *problem.source_features : *problem.target_features, clouds.leaf_dense);
    out.weighted = weighted;
    return SharedSurface(std::move(out));
  });
}

}  // namespace

Viewpoints find_viewpoints(const Problem& problem) {
  const Normalization& n = problem.pair.normalization;
  const GivenViewpoints given(problem.settings, n);
  Viewpoints found = {given.source, given.target};
  if (!problem.settings.free_space || problem.settings.candidates == 0) return found;
  const DownsampledClouds& clouds = problem.downsampled;
  const auto estimate = [&](int side, const Cloud& dense, const Features& features,
                            const Cloud& points, const double center[3],
                            std::optional<Viewpoint>& viewpoint) {
    if (viewpoint) return;
    const double origin[3] = {-center[0] / n.scale, -center[1] / n.scale, -center[2] / n.scale};
    viewpoint = *problem.pair.remembered<Viewpoint>(side, problem.features_by[side], [&] {
      return estimate_sampling_viewpoint(surface(dense, features, clouds.leaf_dense), points,
                                         origin, problem.kernels);
    });
  };
  parallel_for(2, thread_count(problem.settings), [&](std::size_t i) {
    if (i == 0)
      estimate(0, clouds.source_dense, *problem.source_features, problem.pair.source,
               n.center_source, found.source);
    else
      estimate(1, clouds.target_dense, *problem.target_features, problem.pair.target,
               n.center_target, found.target);
  });
  return found;
}

void make_tasks_and_surfaces(const Viewpoints& viewpoints, Stages stages, Problem& problem) {
  const Kernels& kernels = problem.kernels;
  if (problem.settings.candidates == 0) return make_tasks(problem, stages);
  const SharedSurface source = surface_of(0, problem), target = surface_of(1, problem);
  // Mostly grids that one thread makes. Surfaces with given viewpoints are ranked by copies.
  const std::vector<std::function<void()>> parts = {
      [&] { SurfacePair::make_ahead(target, kernels); },
      [&] {
        if (!is_given(viewpoints.source)) SurfaceFit::make_ahead(source, kernels);
      },
      [&] {
        if (!is_given(viewpoints.target)) SurfaceFit::make_ahead(target, kernels);
      },
      [&] { make_tasks(problem, stages); }};
  parallel_for(parts.size(), thread_count(problem.settings), [&](std::size_t i) { parts[i](); });
  problem.surfaces =
      std::make_unique<SurfacePair>(source, target, viewpoints.source, viewpoints.target, kernels);
}

}  // namespace emtr
