#include "problem.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "error.h"
#include "features/kdtree_neighbors.h"
#include "features/resolution.h"
#include "stopwatch.h"
#include "verdict/verdict.h"

namespace emtr {
namespace {

enum NeighborKind { Grid = 0, KdTree = 1, Brute = 2 };

std::unique_ptr<Neighbors> make_neighbors(int kind, const Cloud& cloud, float radius, float leaf,
                                          double queries, const Kernels& kernels) {
  if (kind == KdTree) return make_kdtree(cloud, radius);
  if (kind == Brute) return make_brute_force(cloud, radius);
  return make_neighbors(cloud, radius, leaf, queries, kernels);
}

bool report(const OnProgress& on_progress, const char* stage, int iteration = 0, int iterations = 0,
            double alpha = 0, double beta = 0) {
  return on_progress && on_progress({stage, iteration, iterations, alpha, beta});
}

}  // namespace

Problem::Problem(const emtr_cloud& source, const emtr_cloud& target, const Settings& s,
                 const OnProgress& on_progress)
    : settings(s), kernels(select_kernels()) {
  validate(settings);
  prepare(source, target, on_progress);
}

void Problem::prepare(const emtr_cloud& source, const emtr_cloud& target,
                      const OnProgress& on_progress) {
  Stopwatch watch;
  const auto stop = [&](const char* stage) { return stopped_ = report(on_progress, stage); };

  if (stop("frame")) return;
  watch.lap();
  const NormalisedPair pair = normalise(source, target);
  frame = pair.frame;
  dropped_source = pair.dropped_source;
  dropped_target = pair.dropped_target;
  points_source = pair.source.size();
  points_target = pair.target.size();
  seconds_.frame = watch.lap();

  if (stop("densities")) return;
  watch.lap();
  densities = thin(pair, settings);
  seconds_.densities = watch.lap();

  if (stop("features")) return;
  watch.lap();
  const double normal_radius = settings.normal_radius * densities.leaf_dense;
  const double feature_radius = settings.feature_radius * densities.leaf_dense;
  const int threads = thread_count(settings);
  source_features = describe(densities.source_dense, normal_radius, feature_radius, threads);
  target_features = describe(densities.target_dense, normal_radius, feature_radius, threads);
  seconds_.features = watch.lap();

  if (stop("matching")) return;
  watch.lap();
  match_features();
  make_tasks();
  seconds_.matching = watch.lap();
}

void Problem::match_features() {
  correspondences = match(source_features, target_features,
                          correspondence_cap(static_cast<std::size_t>(settings.max_tims)),
                          thread_count(settings));
  const double resolution =
      (mean_resolution(densities.source_dense) + mean_resolution(densities.target_dense)) / 2;
  tau = settings.tau_factor * resolution;
  tims = form_tims(densities.source_dense, densities.target_dense, correspondences,
                   TaskBeta::threshold(tau, settings));
}

void Problem::make_tasks() {
  const auto make = [this](const Cloud& cloud, float radius, float leaf) {
    // The other cloud has about as many points, and is looked up in about half of the iterations.
    const double queries =
        0.5 * settings.population * settings.iterations * static_cast<double>(cloud.size());
    return make_neighbors(settings.neighbors, cloud, radius, leaf, queries, kernels);
  };
  alpha = std::make_unique<TaskAlpha>(densities, settings, kernels, make);
  beta = std::make_unique<TaskBeta>(tims, tau, settings, kernels);
  // The complement looks far: cells no finer than a share of that keep its structure small.
  const double reach = settings.complement_scale_start;
  auto far = make(densities.target_sparse, static_cast<float>(reach),
                  static_cast<float>(std::max(1.5 * densities.leaf_sparse, reach / 5)));
  complement = std::make_unique<KnowledgeComplement>(
      densities.source_sparse, densities.target_sparse, std::move(far), settings, kernels);
}

std::unique_ptr<Result> Problem::solve(const OnProgress& on_progress) const {
  auto result = std::make_unique<Result>();
  Result& r = *result;
  r.seed = settings.seed;
  r.threads = thread_count(settings);
  r.kernel = kernels.name;
  r.points_source = points_source;
  r.points_target = points_target;
  r.dropped_source = dropped_source;
  r.dropped_target = dropped_target;
  r.sparse_source = densities.source_sparse.size();
  r.sparse_target = densities.target_sparse.size();
  r.dense_source = densities.source_dense.size();
  r.dense_target = densities.target_dense.size();
  r.correspondences = correspondences.size();
  r.tims = tims.formed();
  r.tims_pruned = tims.pruned;
  r.scale = frame.scale;
  std::copy_n(frame.center_source, 3, r.center_source);
  std::copy_n(frame.center_target, 3, r.center_target);
  r.leaf_sparse = densities.leaf_sparse;
  r.leaf_dense = densities.leaf_dense;
  r.seconds_frame = seconds_.frame;
  r.seconds_densities = seconds_.densities;
  r.seconds_features = seconds_.features;
  r.seconds_matching = seconds_.matching;

  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  std::fill_n(r.transformation, 16, unknown);
  r.reason = EMTR_REASON_INTERRUPTED;
  r.fitness = r.inlier_ratio_source = r.inlier_ratio_target = r.inlier_rmse = r.mode_gap = unknown;

  Stopwatch watch;
  if (!stopped_ && !report(on_progress, "evolution", 0, settings.iterations)) {
    watch.lap();
    Rigid guess;
    if (settings.has_guess) guess = frame.to_normalised(from_matrix(settings.guess));
    for (const double offset : guess.t)
      if (!(std::abs(offset) <= 1e6))
        throw Error(EMTR_ERROR_SETTING,
                    "setting 'guess' moves the source a million radii past the target");
    Evolution e = evolve(
        *alpha, *beta, *complement, settings, settings.has_guess ? &guess : nullptr,
        [&](int done, double best_alpha, double best_beta) {
          return report(on_progress, "evolution", done, settings.iterations, best_alpha, best_beta);
        });
    r.seconds_evolution = watch.lap();

    e.stopped |= report(on_progress, "verdict");
    watch.lap();
    const Verdict v = judge(e, *alpha, correspondences.size(), settings);
    r.seconds_verdict = watch.lap();
    r.registered = v.registered;
    r.reason = v.reason;
    r.fitness = v.fitness;
    r.inlier_ratio_source = v.inlier_ratio_source;
    r.inlier_ratio_target = v.inlier_ratio_target;
    r.inlier_rmse = v.inlier_rmse * frame.scale;
    r.mode_gap = v.mode_gap;

    to_matrix(frame.to_user(e.hypotheses[e.best].pose), r.transformation);
    r.lookups_evaluation = e.lookups_evaluation;
    r.lookups_switch = e.lookups_switch;
    r.lookups_complement = e.lookups_complement;
    r.alpha = std::move(e.history_alpha);
    r.beta = std::move(e.history_beta);
  }
  r.iterations = r.alpha.size();
  r.history_alpha = r.alpha.data();
  r.history_beta = r.beta.data();
  r.seconds_total = r.seconds_frame + r.seconds_densities + r.seconds_features +
                    r.seconds_matching + r.seconds_evolution + r.seconds_verdict;
  return result;
}

}  // namespace emtr
