#include "pipeline/problem.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "util/error.h"
#include "neighbors/kdtree_neighbors.h"
#include "neighbors/resolution.h"
#include "correspondences/user_correspondences.h"
#include "priors/make_prior.h"
#include "ranking/given_viewpoints.h"
#include "pipeline/registration.h"
#include "util/stopwatch.h"
#include "util/thread_team.h"

namespace emtr {
namespace {

enum NeighborKind { Grid = 0, KdTree = 1, Brute = 2 };

std::unique_ptr<Neighbors> make_neighbors(int kind, const Cloud& cloud, float radius, float leaf,
                                          double queries, const Kernels& kernels) {
  if (kind == KdTree) return make_kdtree(cloud, radius);
  if (kind == Brute) return make_brute_force(cloud, radius);
  return make_neighbors(cloud, radius, leaf, queries, kernels);
}

/// What is kept of the settings: nothing of the caller's memory.
Settings own(Settings settings) {
  settings.correspondences = nullptr;
  settings.correspondence_count = 0;
  return settings;
}

}  // namespace

emtr_cloud kept(emtr_cloud cloud, const Settings& given) {
  if (given.correspondences) cloud.keep_points = 1;
  return cloud;
}

Problem::Problem(const Normalize& normalized, const Settings& s, CancellationToken& watch)
    : settings(own(s)), kernels(select_kernels()) {
  make(normalized, s, watch);
}

Problem::Problem(const emtr_cloud& source, const emtr_cloud& target, const Settings& s,
                 const OnProgress& on_progress)
    : settings(own(s)), kernels(select_kernels()) {
  CancellationToken watch(on_progress);
  make([&] { return normalize(kept(source, s), kept(target, s), thread_count(settings)); }, s,
       watch);
}

Problem::Problem(const PreprocessedCloudPtr& source, const PreprocessedCloudPtr& target, const Settings& s,
                 const OnProgress& on_progress)
    : settings(own(s)), kernels(select_kernels()) {
  CancellationToken watch(on_progress);
  make([&] { return normalize(source, target); }, s, watch);
}

void Problem::make(const Normalize& normalized, const Settings& given, CancellationToken& watch) {
  validate(settings);
  const CancellationScope watched(&watch);
  try {
    prepare(normalized, given, watch);
  } catch (const Cancelled&) {
    stopped_ = true;
  }
}

void Problem::prepare(const Normalize& normalized, const Settings& given, CancellationToken& watch) {
  const auto enter = [&](const char* stage) {
    if (watch.tell({stage, 0, 0, 0, 0})) throw Cancelled();
  };

  enter("normalization");
  {
    const Timed timed(seconds_.normalization);
    pair = normalized();
    prior = make_prior(settings, normalization);
  }
  dropped_source = pair.preprocessed_source->dropped;
  dropped_target = pair.preprocessed_target->dropped;
  points_source = pair.preprocessed_source->count;
  points_target = pair.preprocessed_target->count;

  enter("downsampling");
  {
    const Timed timed(seconds_.downsampled);
    downsampled = downsample(pair, settings);
  }

  enter("features");
  {
    const Timed timed(seconds_.features);
    load_user_input(given);
    describe_dense();
  }

  enter("matching");
  {
    const Timed timed(seconds_.matching);
    match_features();
    // Neither needs the other, and both are mostly grids that one thread makes.
    parallel_for(2, thread_count(settings),
                [this](std::size_t i) { i == 0 ? make_tasks() : make_surfaces(); });
  }

  if (settings.seeds == 0) return;
  enter("seeds");
  const Timed timed(seconds_.seeds);
  find_seeds();
}

void Problem::load_user_input(const Settings& given) {
  const bool features = have_features(pair);
  if (given.correspondences || given.correspondence_count) {
    if (!given.correspondences)
      throw Error(EMTR_ERROR_ARGUMENT, "correspondences: null, but correspondence_count is not 0");
    UserCorrespondences matches = load_user_correspondences(pair, given.correspondences, given.correspondence_count,
                                           static_cast<std::size_t>(settings.max_correspondences));
    handed = std::make_unique<FeatureClouds>(std::move(matches.clouds));
    correspondences = std::move(matches.correspondences);
    correspondences_found = given.correspondence_count;
  } else if (features) {
    handed = std::make_unique<FeatureClouds>(user_keypoints(pair, downsampled.leaf_dense));
  }
}

void Problem::describe_dense() {
  FeatureDefinition definition = feature_definition(settings, downsampled.leaf_dense);
  definition.trust_normals = trust_normals(pair);
  definition.normals_only = handed != nullptr;
  const int threads = thread_count(settings);
  // One rule for both: only where both sensors are known do the normals turn to them.
  const GivenViewpoints given(settings, normalization);
  const auto described = [&](const Cloud& cloud, const Cloud& normals,
                             const std::optional<Viewpoint>& viewpoint) {
    FeatureDefinition own = definition;
    if (given.both())
      for (std::size_t a = 0; a < 3; ++a) own.viewpoint[a] = static_cast<float>(viewpoint->at[a]);
    return describe(cloud, own, kernels, threads, normals);
  };
  source_features = described(downsampled.source_dense, downsampled.source_normals, given.source);
  target_features = described(downsampled.target_dense, downsampled.target_normals, given.target);
}

void Problem::match_features() {
  const auto most = static_cast<std::size_t>(settings.max_correspondences);
  if (!handed)
    correspondences = match(source_features, target_features, most, kernels, thread_count(settings),
                            &correspondences_found);
  else if (handed->source.dimension)
    correspondences = match(handed->source.view(), handed->target.view(), most, kernels,
                            thread_count(settings), &correspondences_found);
  const auto resolution_of = [this](const Cloud& cloud) {
    return mean_resolution(cloud, downsampled.leaf_dense, kernels, thread_count(settings));
  };
  const double resolution =
      (resolution_of(downsampled.source_dense) + resolution_of(downsampled.target_dense)) / 2;
  tau = settings.tau_factor * resolution;
  // The best of them are enough for the tasks, of those handed in, whose order says nothing, some
  // from all over the list; all of them look for seeds.
  const std::size_t few = std::min(correspondences.size(),
                                   correspondence_cap(static_cast<std::size_t>(settings.max_tims)));
  const bool by_distance = !handed || handed->source.dimension;
  const std::vector<Correspondence> best =
      by_distance
          ? std::vector<Correspondence>(correspondences.begin(),
                                        correspondences.begin() + static_cast<std::ptrdiff_t>(few))
          : spread(correspondences, few);
  tims = form_tims(matched_source(), matched_target(), best, TaskBeta::threshold(tau, settings));
}

void Problem::find_seeds() {
  const double threshold = settings.seed_threshold * downsampled.leaf_dense;
  const Consistency consistency(matched_source(), matched_target(), correspondences, threshold,
                                kernels, thread_count(settings));
  seeds = emtr::find_seeds(consistency, threshold, static_cast<std::size_t>(settings.seeds),
                           thread_count(settings));
}

void Problem::make_surfaces() {
  if (settings.candidates == 0) return;
  const GivenViewpoints given(settings, normalization);
  const auto viewpoints = [this](const Surface& of, const std::optional<Viewpoint>& at) {
    return at ? given_viewpoint(of, *at, kernels) : Viewpoints{};
  };
  Surface source = surface(downsampled.source_dense, source_features, downsampled.leaf_dense),
          target = surface(downsampled.target_dense, target_features, downsampled.leaf_dense);
  const Viewpoints of_source = viewpoints(source, given.source),
                   of_target = viewpoints(target, given.target);
  surfaces = std::make_unique<SurfacePair>(std::move(source), std::move(target), of_source, of_target,
                                        kernels);
}

std::unique_ptr<Result> Problem::solve(CancellationToken& watch) const {
  return Registration(*this, watch).run();
}

std::unique_ptr<Result> Problem::solve(const OnProgress& on_progress) const {
  CancellationToken watch(on_progress, settings.time_limit);
  return solve(watch);
}

void Problem::make_tasks() {
  const auto make = [this](const Cloud& cloud, float radius, float leaf) {
    // The other cloud has about as many points, and is looked up in about half of the iterations.
    const double expected_queries =
        0.5 * settings.population * settings.iterations * static_cast<double>(cloud.size());
    return make_neighbors(settings.neighbors, cloud, radius, leaf, expected_queries, kernels);
  };
  alpha = std::make_unique<TaskAlpha>(downsampled, settings, kernels, make);
  beta = std::make_unique<TaskBeta>(tims, tau, settings, kernels);
  // The complement looks far: cells no finer than a share of that keep its structure small.
  const double reach = settings.complement_scale_start;
  auto far = make(downsampled.target_sparse, static_cast<float>(reach),
                  static_cast<float>(std::max(1.5 * downsampled.leaf_sparse, reach / 5)));
  complement = std::make_unique<KnowledgeComplement>(
      downsampled.source_sparse, downsampled.target_sparse, std::move(far), settings, kernels);
}

}  // namespace emtr
