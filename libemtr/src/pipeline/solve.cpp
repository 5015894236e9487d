#include "pipeline/solve.h"

#include "pipeline/make_result.h"
#include "pipeline/progress.h"
#include "pipeline/search_stages.h"

namespace emtr {
namespace {

/// Refines the pose and judges it.
void refine_and_judge(const Problem& problem, Progress& progress, Solution& found) {
  if (problem.settings.refine) {
    progress.enter(Stage::Refinement);
    refine_pose(problem, found);
    believe_but_for_unconstrained(problem, found);
    resolve_by_colors(problem, found);
  }

  progress.enter(Stage::Verdict);
  recognize_symmetry(found);
  measure_overlap(problem, found);
  weigh_changed_source(problem, found);
}

/// Searches once and ranks what was found.
void find_candidates(const Problem& problem, const std::vector<Rigid>* poses, Progress& progress,
                     Solution& found) {
  progress.enter(Stage::Evolution);
  shortlist_seeds(problem, found);
  if (poses)
    take_poses(problem, *poses, found);
  else
    evolve(problem, progress, found);

  if (found.candidates) {
    progress.enter(Stage::Candidates);
    rank_candidates(problem, found);
  }
}

/// Runs the stages of the search; Cancelled leaves what they have found by then.
void run_stages(const Problem& problem, const std::vector<Rigid>* poses, Progress& progress,
                Solution& found) {
  if (problem.matches_decide) {
    progress.enter(Stage::Verdict);
    judge_match_poses(problem, found);
    return;
  }

  find_candidates(problem, poses, progress, found);
  if (needs_fallback_search(problem, found)) {
    progress.enter(Stage::FallbackSearch);
    search_again(problem, found);
  }

  refine_and_judge(problem, progress, found);
  if (needs_second_look(problem, found)) {
    progress.enter(Stage::FallbackSearch);
    search_again(problem, found);
    refine_and_judge(problem, progress, found);
  }
}

/// Runs the stages that `run(progress, found)` runs.
template <class Run>
Solution search(const Problem& problem, CancellationToken& token, Run run) {
  Solution found;
  found.seconds = problem.seconds;
  found.stopped = problem.stopped;
  if (found.stopped) return found;
  const CancellationScope scope(&token);
  try {
    Progress progress(token, problem.settings.iterations, found.seconds);
    run(progress, found);
  } catch (const Cancelled&) {
    found.stopped = true;
    take_best_so_far(problem, found);
  }
  return found;
}

}  // namespace

Solution search_candidates(const Problem& problem, CancellationToken& token) {
  Solution found;
  const CancellationScope scope(&token);
  Progress progress(token, problem.settings.iterations, found.seconds);
  find_candidates(problem, nullptr, progress, found);
  return found;
}

Solution search_pose(const Problem& problem, CancellationToken& token,
                     const std::vector<Rigid>* poses) {
  Solution found = search(problem, token, [&](Progress& progress, Solution& out) {
    run_stages(problem, poses, progress, out);
  });
  if (found.pose && !problem.matches_decide) judge_pose(problem, found);
  return found;
}

Solution search_once(const Problem& problem, CancellationToken& token) {
  Solution found = search(problem, token, [&](Progress& progress, Solution& out) {
    find_candidates(problem, nullptr, progress, out);
    if (!is_doubtful(problem, out)) refine_and_judge(problem, progress, out);
  });
  if (found.overlap || (found.stopped && found.pose)) judge_pose(problem, found);
  return found;
}

std::unique_ptr<Result> conclude(const Problem& problem, const Solution& found,
                                 const CancellationToken& token) {
  auto result = make_result(problem, found);
  if (found.stopped)
    result->reason = token.timed_out() ? EMTR_REASON_TIME_LIMIT : EMTR_REASON_INTERRUPTED;
  return result;
}

std::unique_ptr<Result> solve(const Problem& problem, CancellationToken& token,
                              const std::vector<Rigid>* poses) {
  return conclude(problem, search_pose(problem, token, poses), token);
}

}  // namespace emtr
