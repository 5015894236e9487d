#include "pipeline/search_stages.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "geometry/pose_distance.h"
#include "priors/make_prior.h"
#include "refinement/unconstrained_motion.h"
#include "settings/choices.h"
#include "util/stopwatch.h"
#include "util/thread_team.h"

namespace emtr {
namespace {

/// Returns the user's guess, if there is one.
std::vector<Rigid> guess(const Problem& problem) {
  if (!problem.settings.has_guess) return {};
  const Rigid pose = normalized_guess(problem.settings, problem.pair.normalization);
  return {admissible_pose(problem, pose)};
}

Starts starts(const Problem& problem, const std::vector<Rigid>& shortlist) {
  const Settings& settings = problem.settings;
  // At least half of the swarm stays where chance put it.
  const auto most =
      static_cast<std::size_t>(std::min(settings.injected_seeds, settings.population / 2));
  const auto count = static_cast<std::ptrdiff_t>(std::min(most, shortlist.size()));
  return {guess(problem), {shortlist.begin(), shortlist.begin() + count}};
}

void take_best_candidate(const Problem& problem, Solution& found) {
  found.used_colors = false;
  const std::vector<Candidate>& ranked = found.candidates->ranked();
  found.pose = ranked.front().pose;
  found.color_evidence.reset();
  believe(problem, ranked, found);
}

/// Tells whether the surfaces fit worse on the way between two candidates, although they leave its
/// direction unconstrained at its end: the windows of a facade that shows nothing of their depth.
bool is_apart(const SurfacePair& surfaces, const Candidate& a, const Candidate& b,
              const HessianSpectrum& spectrum) {
  Ranking::Scratch scratch;
  // If there are several periods between the two, some of these are not at a whole one.
  for (const double fraction : {0.5, 0.25, 0.125, 0.375}) {
    const Rigid pose = between(a.pose, b.pose, spectrum, fraction);
    if (!is_rival_score(surfaces.ranking().evaluate(pose, scratch).score, b.score)) return true;
  }
  return false;
}

}  // namespace

void believe(const Problem& problem, const std::vector<Candidate>& ranked, Solution& found) {
  found.confidence = estimate_confidence(ranked, problem.downsampled.source_dense.size(),
                                         problem.downsampled.target_dense.size());
  if (problem.pair.extruded)
    found.confidence->probability =
        lower_outline_confidence(found.confidence->probability, ranked.front().score);
}

const FineSurfaces& fine(const Problem& problem, Solution& found) {
  if (!found.fine)
    found.fine = std::make_unique<FineSurfaces>(
        fine_surfaces(problem.pair, problem.settings.refine_leaf, problem.downsampled.leaf_dense,
                      problem.kernels, thread_count(problem.settings)));
  return *found.fine;
}

Rigid admissible_pose(const Problem& problem, const Rigid& pose) {
  return problem.prior ? problem.prior->project(pose) : pose;
}

void judge_match_poses(const Problem& problem, Solution& found) {
  const MatchPose& best = problem.match_poses.front();
  found.pose = best.pose;
  found.refined = constraints_of(problem.user_matches.matches, best, problem.prior.get());
  found.match_verdict =
      judge_matches(problem.match_poses, found.refined.unconstrained > 0, problem.settings);
}

void shortlist_seeds(const Problem& problem, Solution& found) {
  if (problem.surfaces) {
    found.candidates = std::make_unique<CandidateSearch>(
        problem.pair, *problem.surfaces, problem.settings, problem.kernels, problem.prior.get());
    found.shortlist = found.candidates->shortlist(problem.seeds);
    return;
  }
  std::vector<Rigid> poses;
  for (const Seed& seed : problem.seeds) poses.push_back(seed.pose);
  found.shortlist = admissible(poses, problem.prior.get());
}

void evolve(const Problem& problem, Progress& progress, Solution& found) {
  found.evolution = evolve(
      *problem.alpha, *problem.beta, *problem.complement, problem.settings,
      starts(problem, found.shortlist),
      [&](int done, double best_alpha, double best_beta) {
        return progress.iterated(done, best_alpha, best_beta);
      },
      problem.prior.get());
  const Evolution& evolution = found.evolution;
  if (!evolution.hypotheses.empty()) found.pose = evolution.hypotheses[evolution.best].pose;
  if (evolution.stopped) throw Cancelled();
}

void take_poses(const Problem& problem, const std::vector<Rigid>& poses, Solution& found) {
  const TaskAlpha& alpha = *problem.alpha;
  const int threads = thread_count(problem.settings);
  std::vector<TaskAlpha::Scratch> scratch(static_cast<std::size_t>(threads));
  std::vector<Hypothesis> known(poses.size());
  ThreadTeam::with(threads, [&](ThreadTeam& team) {
    team.parallel(poses.size(), [&](std::size_t i, std::size_t thread) {
      const Rigid pose = admissible_pose(problem, poses[i]);
      known[i] = {pose, alpha.evaluate(EMTR_RESOLUTION_DENSE, pose, scratch[thread])};
    });
  });
  const auto best = std::min_element(
      known.begin(), known.end(),
      [](const Hypothesis& a, const Hypothesis& b) { return a.fitness < b.fitness; });
  found.pose = best->pose;
  Evolution& evolution = found.evolution;
  evolution.best = static_cast<std::size_t>(best - known.begin());
  evolution.resolution = EMTR_RESOLUTION_DENSE;
  evolution.queries_evaluation = poses.size() * alpha.queries(EMTR_RESOLUTION_DENSE);
  evolution.hypotheses = std::move(known);
}

void rank_candidates(const Problem& problem, Solution& found) {
  std::vector<Rigid> poses = guess(problem), swarm;
  poses.insert(poses.end(), found.shortlist.begin(), found.shortlist.end());
  for (const MatchPose& found_by_matches : problem.match_poses)
    poses.push_back(admissible_pose(problem, found_by_matches.pose));
  for (const Hypothesis& hypothesis : found.evolution.hypotheses) swarm.push_back(hypothesis.pose);
  found.candidates->add(poses, swarm);
  take_best_candidate(problem, found);
}

bool is_doubtful(const Problem& problem, const Solution& found) {
  if (!found.confidence) return false;
  const Candidate& best = found.candidates->ranked().front();
  return found.confidence->probability < problem.settings.fallback_confidence ||
         is_mostly_plane(best) || is_nearly_rivaled(best, *found.confidence);
}

bool is_strange(const Solution& found) {
  return found.confidence && found.refined.succeeded &&
         (found.refined.unconstrained > 0 || found.confidence->mirrored ||
          found.confidence->scale_factor != 1);
}

bool needs_fallback_search(const Problem& problem, const Solution& found) {
  return found.confidence && in_use(problem.settings.fallback_search, is_doubtful(problem, found));
}

bool needs_second_look(const Problem& problem, const Solution& found) {
  if (!found.confidence || found.candidates->used_fallback_search()) return false;
  return in_use(problem.settings.fallback_search, is_strange(found));
}

void search_again(const Problem& problem, Solution& found) {
  found.candidates->run_fallback_search();
  take_best_candidate(problem, found);
}

void refine_pose(const Problem& problem, Solution& found) {
  found.refined = refine(fine(problem, found), *found.pose, problem.settings, problem.kernels,
                         problem.prior.get());
  found.pose = found.refined.pose;
}

void believe_but_for_unconstrained(const Problem& problem, Solution& found) {
  const Refined& refined = found.refined;
  const HessianSpectrum& spectrum = refined.hessian_spectrum;
  found.moves_freely = false;
  if (!found.confidence || !refined.succeeded || spectrum.unconstrained == 0) return;
  if (refined.unconstrained < spectrum.unconstrained) return;  // a prior tells the poses apart
  const std::vector<Candidate>& ranked = found.candidates->ranked();
  const Candidate& best = ranked.front();
  std::vector<Candidate> others{best};
  for (auto candidate = ranked.begin() + 1; candidate != ranked.end(); ++candidate) {
    const bool same = is_same_but_unconstrained(candidate->pose, best.pose, spectrum);
    if (same && is_rival_score(candidate->score, best.score) &&
        !is_same_pose(candidate->pose, best.pose, kDistinctPose) &&
        is_apart(*problem.surfaces, *candidate, best, spectrum))
      return;
    if (!same) others.push_back(*candidate);
  }
  found.moves_freely = true;
  believe(problem, others, found);
  // Moved on along the plane that they share, the clouds may fit far better than any candidate.
  if (is_hardly_explained(best))
    found.confidence->probability = lower_for_rival(found.confidence->probability);
}

void recognize_symmetry(Solution& found) {
  if (found.confidence)
    found.symmetry =
        find_symmetry(found.candidates->ranked().front(), found.confidence->alternatives,
                      found.moves_freely ? &found.refined.hessian_spectrum : nullptr);
}

void measure_overlap(const Problem& problem, Solution& found) {
  const FineSurfaces& surfaces = fine(problem, found);
  const int threads = thread_count(problem.settings);
  const Overlap overlap =
      evaluate_overlap(problem.pair, surfaces, *found.pose, problem.kernels, threads);
  // Without refinement the surfaces need not lie flush where the pose is right.
  if (found.refined.succeeded && found.confidence)
    found.confidence->probability = lower_confidence(
        found.confidence->probability,
        surface_mismatch(overlap, problem.pair, surfaces, problem.kernels, threads));
  found.overlap = overlap;
}

void weigh_changed_source(const Problem& problem, Solution& found) {
  // Where the colors have decided, they tell a mirror image and a scale apart too.
  if (!found.confidence || found.used_colors ||
      found.confidence->probability < lower_for_rival(problem.settings.minimum_confidence))
    return;  // in doubt for more than a rival
  const Candidate& best = found.candidates->ranked().front();
  double mirrored = 0;
  Rescaled rescaled;
  parallel_for(2, thread_count(problem.settings), [&](std::size_t i) {
    if (i == 0)
      rescaled = best_scale(*problem.surfaces, best.pose, problem.kernels);
    else
      mirrored = mirrored_score(*problem.surfaces, best.pose, problem.kernels);
  });
  weigh_changed_source(best, mirrored, rescaled, *found.confidence);
}

void take_best_so_far(const Problem& problem, Solution& found) {
  // Some candidates were ranked before the rest could be; once all are, the pose is theirs.
  if (!found.confidence && found.candidates && !found.candidates->ranked().empty())
    found.pose = found.candidates->ranked().front().pose;
  else if (found.pose)
    return;
  else if (!found.shortlist.empty())
    found.pose = found.shortlist.front();
  else if (!problem.seeds.empty())
    found.pose = admissible_pose(problem, problem.seeds.front().pose);
}

void judge_pose(const Problem& problem, Solution& found) {
  const Timed timed(found.seconds[Stage::Verdict]);
  found.evolution.stopped = found.stopped;
  found.verdict = judge(found.evolution, *found.pose, *problem.alpha,
                        problem.correspondences.size(), problem.settings);
}

}  // namespace emtr
