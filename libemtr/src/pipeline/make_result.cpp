#include "pipeline/make_result.h"

#include <algorithm>
#include <array>
#include <limits>

namespace emtr {
namespace {

void fill_unknown(emtr_result& r) {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  std::fill_n(r.transformation, 16, kUnknown);
  std::fill_n(r.information, 36, kUnknown);
  std::fill_n(r.hessian_eigenvalues, 6, kUnknown);
  std::fill_n(r.hessian_eigenvectors, 36, kUnknown);
  r.unconstrained_directions = -1;
  r.reason = EMTR_REASON_INTERRUPTED;
  r.fitness = r.inlier_ratio_source = r.inlier_ratio_target = r.fitness_gap = kUnknown;
  r.overlap_source = r.overlap_target = r.inlier_rmse = r.inlier_rmse_plane = kUnknown;
  r.leaf_fine = kUnknown;
  r.confidence = r.score = r.surface_fit = r.violation = r.score_gap = kUnknown;
  r.surface_near = r.evidence = r.scale_factor = kUnknown;
  r.color_correlation = r.color_evidence = kUnknown;
  r.symmetry = "unknown";
  std::fill_n(r.symmetry_axis, 3, kUnknown);
  r.symmetry_period = kUnknown;
  r.scale = r.scale_constraint = kUnknown;
  std::fill_n(r.information_similarity, 49, kUnknown);
}

void fill_problem(const Problem& problem, emtr_result& r) {
  r.seed = problem.settings.seed;
  r.threads = thread_count(problem.settings);
  r.kernel = problem.kernels.name;
  if (const PreprocessedCloud* source = problem.pair.preprocessed_source.get()) {
    r.points_source = source->count;
    r.dropped_source = source->dropped;
    r.strays_source = source->strays;
  }
  if (const PreprocessedCloud* target = problem.pair.preprocessed_target.get()) {
    r.points_target = target->count;
    r.dropped_target = target->dropped;
    r.strays_target = target->strays;
  }
  const Normalization& normalization = problem.pair.normalization;
  r.normalization_scale = normalization.scale;
  std::copy_n(normalization.center_source, 3, r.center_source);
  std::copy_n(normalization.center_target, 3, r.center_target);
  r.correspondences_found = problem.correspondences_found;
  if (problem.matches_decide) {  // then the other stages have no part in the result
    r.correspondences = problem.user_matches.matches.size();
    return;
  }
  const DownsampledClouds& clouds = problem.downsampled;
  r.sparse_source = clouds.source_sparse.size();
  r.sparse_target = clouds.target_sparse.size();
  r.dense_source = clouds.source_dense.size();
  r.dense_target = clouds.target_dense.size();
  r.leaf_sparse = clouds.leaf_sparse;
  r.leaf_dense = clouds.leaf_dense;
  r.correspondences = problem.correspondences.size();
  r.tims = problem.tims.formed();
  r.tims_pruned = problem.tims.pruned;
  r.seeds = problem.seeds.size();
}

void fill_evolution(const Evolution& evolution, Result& r) {
  r.queries_evaluation = evolution.queries_evaluation;
  r.queries_switch = evolution.queries_switch;
  r.queries_complement = evolution.queries_complement;
  r.alpha = evolution.history_alpha;
  r.beta = evolution.history_beta;
  r.iterations = r.alpha.size();
  r.history_alpha = r.alpha.data();
  r.history_beta = r.beta.data();
}

void fill_verdict(const Verdict& verdict, emtr_result& r) {
  r.registered = verdict.registered;
  r.reason = verdict.reason;
  r.fitness = verdict.fitness;
  r.inlier_ratio_source = verdict.inlier_ratio_source;
  r.inlier_ratio_target = verdict.inlier_ratio_target;
  r.fitness_gap = verdict.fitness_gap;
}

void fill_alternatives(const Confidence& confidence, const Problem& problem, Result& r) {
  for (const Candidate& other : confidence.alternatives)
    write_alternative(problem, other, r.others.emplace_back());
  r.alternatives = r.others.data();
  r.alternative_count = r.others.size();
}

/// With candidates the confidence decides, and not the fitness.
void fill_candidates(const Problem& problem, const Solution& found, Result& r) {
  const Candidate& best = found.candidates->ranked().front();
  r.candidates = found.candidates->ranked().size();
  r.used_fallback_search = found.candidates->used_fallback_search();
  r.score = best.score;
  r.surface_fit = best.fit.score;
  r.surface_near = best.fit.near;
  r.violation = best.violation;
  if (!found.confidence) return;  // stopped before the others were ranked
  r.score_gap = found.confidence->score_gap;
  r.confidence = found.confidence->probability;
  r.evidence = found.confidence->evidence;
  r.scale_factor = found.confidence->scale_factor;
  fill_alternatives(*found.confidence, problem, r);
  if (found.stopped) return;
  const bool unconstrained = found.refined.unconstrained > 0 && found.refined.succeeded;
  r.reason = reason(best, *found.confidence, unconstrained, problem.correspondences.size(),
                    problem.settings);
  r.registered = r.reason == EMTR_REASON_REGISTERED;
}

/// Where the matches decide, a score is the share of them that are inliers.
void fill_matches(const Problem& problem, const Solution& found, Result& r) {
  r.confidence = found.match_verdict->confidence;
  r.reason = found.match_verdict->reason;
  r.registered = r.reason == EMTR_REASON_REGISTERED;
  const std::vector<MatchPose>& poses = problem.match_poses;
  const auto score = [&](const MatchPose& pose) {
    return static_cast<double>(pose.inliers.size()) /
           static_cast<double>(problem.user_matches.matches.size());
  };
  r.score = r.score_gap = score(poses.front());
  r.inlier_rmse = found.refined.rmse * problem.pair.normalization.scale;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    emtr_alternative& out = r.others.emplace_back();
    to_matrix(problem.pair.normalization.to_user(poses[i].pose), out.transformation);
    out.score = std::min(score(poses[i]), r.score);
    out.surface_fit = out.violation = out.evidence = std::numeric_limits<double>::quiet_NaN();
    r.score_gap = r.score - r.others.front().score;
  }
  r.alternatives = r.others.data();
  r.alternative_count = r.others.size();
}

void fill_refinement(const Refined& refined, double scale, emtr_result& r) {
  r.refined = 1;
  // A translation is `scale` times as long in the user's unit, and its information that much less.
  const double unit[3] = {1, scale, scale * scale};
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      r.information[6 * i + j] = refined.information[6 * i + j] / unit[(i >= 3) + (j >= 3)];
  r.unconstrained_directions = refined.hessian_spectrum.unconstrained;
  for (int i = 0; i < 6; ++i) {
    r.hessian_eigenvalues[i] = refined.hessian_spectrum.eigenvalues[i];
    std::copy_n(refined.hessian_spectrum.eigenvectors[i], 6, r.hessian_eigenvectors + 6 * i);
  }
}

void fill_symmetry(const Symmetry& symmetry, double scale, emtr_result& r) {
  r.symmetry = name_of(symmetry.kind);
  r.symmetry_order = symmetry.order;
  for (int i = 0; i < 3; ++i) r.symmetry_axis[i] = symmetry.axis[i];
  r.symmetry_period = symmetry.period * scale;
}

void fill_colors(const Solution& found, emtr_result& r) {
  r.used_colors = found.used_colors;
  if (!found.color_evidence) return;
  r.color_correlation = found.color_evidence->correlation;
  r.color_evidence = found.color_evidence->evidence;
}

void fill_overlap(const Overlap& overlap, double leaf, double scale, emtr_result& r) {
  r.leaf_fine = leaf;
  r.overlap_source = overlap.overlap_source;
  r.overlap_target = overlap.overlap_target;
  r.inlier_rmse = overlap.rmse * scale;
  r.inlier_rmse_plane = overlap.plane_rmse * scale;
}

void fill_seconds(const StageSeconds& seconds, emtr_result& r) {
  constexpr std::array<double emtr_result::*, kStageCount> fields = {
      &emtr_result::seconds_normalization,   &emtr_result::seconds_scale_search,
      &emtr_result::seconds_downsampling,    &emtr_result::seconds_features,
      &emtr_result::seconds_matching,        &emtr_result::seconds_seeds,
      &emtr_result::seconds_evolution,       &emtr_result::seconds_candidates,
      &emtr_result::seconds_fallback_search, &emtr_result::seconds_refinement,
      &emtr_result::seconds_verdict};
  for (std::size_t i = 0; i < kStageCount; ++i) {
    r.*fields[i] = seconds.values[i];
    r.seconds_total += seconds.values[i];
  }
}

}  // namespace

void write_alternative(const Problem& problem, const Candidate& candidate, emtr_alternative& out) {
  to_matrix(problem.pair.normalization.to_user(candidate.pose), out.transformation);
  out.score = candidate.score;
  out.surface_fit = candidate.fit.score;
  out.violation = candidate.violation;
  out.evidence = evidence(candidate, problem.downsampled.source_dense.size(),
                          problem.downsampled.target_dense.size());
}

std::unique_ptr<Result> make_result(const Problem& problem, const Solution& found) {
  auto result = std::make_unique<Result>();
  const Normalization& normalization = problem.pair.normalization;
  fill_unknown(*result);
  fill_problem(problem, *result);
  fill_evolution(found.evolution, *result);
  if (found.pose) {
    to_matrix(normalization.to_user(*found.pose), result->transformation);
    result->scale = 1;
  }
  if (found.verdict) fill_verdict(*found.verdict, *result);
  if (found.candidates && !found.candidates->ranked().empty())
    fill_candidates(problem, found, *result);
  if (found.symmetry) fill_symmetry(*found.symmetry, normalization.scale, *result);
  if (found.match_verdict) fill_matches(problem, found, *result);
  if (found.refined.succeeded) fill_refinement(found.refined, normalization.scale, *result);
  fill_colors(found, *result);
  if (found.overlap) fill_overlap(*found.overlap, found.fine->leaf(), normalization.scale, *result);
  fill_seconds(found.seconds, *result);
  return result;
}

}  // namespace emtr
