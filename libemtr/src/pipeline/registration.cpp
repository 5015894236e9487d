#include "pipeline/registration.h"

#include <algorithm>
#include <limits>

#include "priors/make_prior.h"
#include "util/stopwatch.h"
#include "verdict/overlap.h"
#include "verdict/verdict.h"

namespace emtr {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

}  // namespace

Registration::Registration(const Problem& problem, CancellationToken& watch)
    : problem_(problem),
      settings_(problem.settings),
      prior_(problem.prior.get()),
      watch_(watch),
      result_(std::make_unique<Result>()),
      stopped_(problem.stopped()) {}

std::unique_ptr<Result> Registration::run() {
  Result& r = *result_;
  describe_problem();
  if (!stopped_) search();
  Stopwatch watch;
  if (answer_) conclude();
  r.seconds_verdict += watch.lap();
  if (stopped_) r.reason = watch_.late() ? EMTR_REASON_TIME_LIMIT : EMTR_REASON_INTERRUPTED;
  r.iterations = r.alpha.size();
  r.history_alpha = r.alpha.data();
  r.history_beta = r.beta.data();
  r.alternatives = r.others.data();
  r.alternative_count = r.others.size();
  r.seconds_total = r.seconds_normalization + r.seconds_downsampling + r.seconds_features +
                    r.seconds_matching + r.seconds_seeds + r.seconds_evolution +
                    r.seconds_candidates + r.seconds_fallback_search + r.seconds_refinement +
                    r.seconds_verdict;
  return std::move(result_);
}

void Registration::search() {
  const CancellationScope watched(&watch_);
  Result& r = *result_;
  try {
    enter("evolution");
    {
      const Timed timed(r.seconds_evolution);
      evolve();
    }
    if (search_) {
      enter("candidates");
      const Timed timed(r.seconds_candidates);
      rank();
    }
    if (unsure()) {
      enter("fallback_search");
      const Timed timed(r.seconds_fallback_search);
      search_->run_fallback_search();
      settle();
    }
    if (settings_.refine) {
      enter("refinement");
      const Timed timed(r.seconds_refinement);
      refine();
    }
    enter("verdict");
    const Timed timed(r.seconds_verdict);
    conclude_overlap();
  } catch (const Cancelled&) {
    stopped_ = true;
    salvage();
  }
}

void Registration::enter(const char* stage) {
  if (watch_.tell({stage, 0, settings_.iterations, 0, 0})) throw Cancelled();
}

void Registration::salvage() {
  const bool some_ranked = search_ && !search_->ranked().empty();
  if (some_ranked && !ranked_)
    answer_ = search_->ranked().front().pose;
  else if (answer_)
    return;
  else if (!shortlist_.empty())
    answer_ = shortlist_.front();
  else if (!problem_.seeds.empty())
    answer_ = admitted(problem_.seeds.front().pose);
}

void Registration::describe_problem() {
  Result& r = *result_;
  const DownsampledClouds& d = problem_.downsampled;
  r.seed = settings_.seed;
  r.threads = thread_count(settings_);
  r.kernel = problem_.kernels.name;
  r.points_source = problem_.points_source;
  r.points_target = problem_.points_target;
  r.dropped_source = problem_.dropped_source;
  r.dropped_target = problem_.dropped_target;
  r.sparse_source = d.source_sparse.size();
  r.sparse_target = d.target_sparse.size();
  r.dense_source = d.source_dense.size();
  r.dense_target = d.target_dense.size();
  r.correspondences = problem_.correspondences.size();
  r.correspondences_found = problem_.correspondences_found;
  r.tims = problem_.tims.formed();
  r.tims_pruned = problem_.tims.pruned;
  r.seeds = problem_.seeds.size();
  r.normalization_scale = problem_.normalization.scale;
  std::copy_n(problem_.normalization.center_source, 3, r.center_source);
  std::copy_n(problem_.normalization.center_target, 3, r.center_target);
  r.leaf_sparse = d.leaf_sparse;
  r.leaf_dense = d.leaf_dense;
  r.seconds_normalization = problem_.seconds_.normalization;
  r.seconds_downsampling = problem_.seconds_.downsampled;
  r.seconds_features = problem_.seconds_.features;
  r.seconds_matching = problem_.seconds_.matching;
  r.seconds_seeds = problem_.seconds_.seeds;

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
}

std::vector<Rigid> Registration::guess() const {
  if (!settings_.has_guess) return {};
  return {admitted(normalized_guess(settings_, problem_.normalization))};
}

Rigid Registration::admitted(const Rigid& pose) const {
  return prior_ ? prior_->project(pose) : pose;
}

Starts Registration::starts() const {
  // At least half of the swarm stays where chance put it.
  const auto most =
      static_cast<std::size_t>(std::min(settings_.injected_seeds, settings_.population / 2));
  const std::size_t n = std::min(most, shortlist_.size());
  return {guess(), {shortlist_.begin(), shortlist_.begin() + static_cast<std::ptrdiff_t>(n)}};
}

void Registration::evolve() {
  if (problem_.surfaces) {
    search_ = std::make_unique<CandidateSearch>(problem_.pair, *problem_.surfaces, settings_,
                                                problem_.kernels, prior_);
    shortlist_ = search_->shortlist(problem_.seeds);
  } else {
    for (const Seed& seed : problem_.seeds) shortlist_.push_back(seed.pose);
    shortlist_ = admissible(shortlist_, prior_);
  }
  evolution_ = emtr::evolve(
      *problem_.alpha, *problem_.beta, *problem_.complement, settings_, starts(),
      [&](int done, double alpha, double beta) {
        return watch_.tell({"evolution", done, settings_.iterations, alpha, beta});
      },
      prior_);
  result_->queries_evaluation = evolution_.queries_evaluation;
  result_->queries_switch = evolution_.queries_switch;
  result_->queries_complement = evolution_.queries_complement;
  if (!evolution_.hypotheses.empty()) answer_ = evolution_.hypotheses[evolution_.best].pose;
  if (evolution_.stopped) throw Cancelled();
}

void Registration::rank() {
  std::vector<Rigid> poses = guess(), remembered;
  poses.insert(poses.end(), shortlist_.begin(), shortlist_.end());
  for (const Hypothesis& h : evolution_.hypotheses) remembered.push_back(h.pose);
  search_->add(poses, remembered);
  settle();
}

void Registration::settle() {
  answer_ = search_->ranked().front().pose;
  confidence_ = estimate_confidence(search_->ranked(), problem_.downsampled.source_dense.size(),
                    problem_.downsampled.target_dense.size());
  ranked_ = true;
}

bool Registration::unsure() const {
  if (!search_ || search_->ranked().empty()) return false;
  return in_use(settings_.fallback_search, confidence_.confidence < settings_.fallback_confidence);
}

const FineSurfaces& Registration::fine() {
  if (!fine_)
    fine_ = std::make_unique<FineSurfaces>(
        fine_surfaces(problem_.pair, settings_.refine_leaf, problem_.kernels));
  return *fine_;
}

void Registration::refine() {
  refined_ = emtr::refine(fine(), *answer_, settings_, problem_.kernels, prior_);
  answer_ = refined_.pose;
}

void Registration::conclude() {
  Result& r = *result_;
  evolution_.stopped = stopped_;
  const Verdict v =
      judge(evolution_, *answer_, *problem_.alpha, problem_.correspondences.size(), settings_);
  r.registered = v.registered;
  r.reason = v.reason;
  r.fitness = v.fitness;
  r.inlier_ratio_source = v.inlier_ratio_source;
  r.inlier_ratio_target = v.inlier_ratio_target;
  r.fitness_gap = v.fitness_gap;
  to_matrix(problem_.normalization.to_user(*answer_), r.transformation);
  r.alpha = evolution_.history_alpha;
  r.beta = evolution_.history_beta;

  if (search_ && !search_->ranked().empty()) conclude_candidates();
  if (refined_.succeeded) conclude_refinement();
}

void Registration::conclude_candidates() {
  Result& r = *result_;
  const Candidate& best = search_->ranked().front();
  r.candidates = search_->ranked().size();
  r.used_fallback_search = search_->used_fallback_search();
  r.score = best.score;
  r.surface_fit = best.fit.score;
  r.violation = best.violation;
  if (!ranked_) return;  // stopped before the others were
  r.score_gap = confidence_.gap;
  r.confidence = confidence_.confidence;
  if (!stopped_) {
    r.reason = reason(best, confidence_, refined_.unconstrained > 0 && refined_.succeeded,
                      problem_.correspondences.size(), settings_);
    r.registered = r.reason == EMTR_REASON_REGISTERED;
  }
  for (const Candidate& other : confidence_.others) {
    r.others.emplace_back();
    to_matrix(problem_.normalization.to_user(other.pose), r.others.back().transformation);
    r.others.back().score = other.score;
  }
}

void Registration::conclude_refinement() {
  Result& r = *result_;
  r.refined = 1;
  // A shift in the user's unit is `scale` times as many, its information that much less.
  const double unit[3] = {1, r.normalization_scale, r.normalization_scale * r.normalization_scale};
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      r.information[6 * i + j] = refined_.information[6 * i + j] / unit[(i >= 3) + (j >= 3)];
  r.unconstrained_directions = refined_.hessian_spectrum.free;
  for (int i = 0; i < 6; ++i) {
    r.hessian_eigenvalues[i] = refined_.hessian_spectrum.values[i];
    std::copy_n(refined_.hessian_spectrum.directions[i], 6, r.hessian_eigenvectors + 6 * i);
  }
}

void Registration::conclude_overlap() {
  Result& r = *result_;
  const Overlap agreement = evaluate_overlap(problem_.pair, fine(), *answer_, problem_.kernels);
  // Without refinement the surfaces need not lie flush where the pose is right.
  if (refined_.succeeded && ranked_)
    confidence_.confidence =
        lower_confidence(confidence_.confidence, surface_mismatch(agreement, problem_.pair, fine(), problem_.kernels));
  r.leaf_fine = fine().leaf();
  r.overlap_source = agreement.overlap_source;
  r.overlap_target = agreement.overlap_target;
  r.inlier_rmse = agreement.rmse * r.normalization_scale;
  r.inlier_rmse_plane = agreement.plane_rmse * r.normalization_scale;
}

}  // namespace emtr
