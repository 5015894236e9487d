#pragma once

#include "pipeline/problem.h"
#include "pipeline/progress.h"
#include "pipeline/solution.h"

namespace emtr {

/// Returns the pose, or the nearest one that the prior admits.
Rigid admissible_pose(const Problem& problem, const Rigid& pose);

// The steps of solve(). Each reads what the ones before it have found, and adds what it finds.

/// Takes the pose from the matches, and judges it by them.
void judge_match_poses(const Problem& problem, Solution& found);

/// Puts the seeds that keep to the prior on the shortlist, the best ones where they can be ranked.
void shortlist_seeds(const Problem& problem, Solution& found);

/// Evolves both swarms from the guess and the shortlist. Throws Cancelled when it is stopped, with
/// the evolution so far in `found`.
void evolve(const Problem& problem, Progress& progress, Solution& found);

/// Takes poses that are known in the place of those that the swarm would find. Not empty.
void take_poses(const Problem& problem, const std::vector<Rigid>& poses, Solution& found);

/// Refines and ranks the guess, the shortlist and the poses of the swarm.
void rank_candidates(const Problem& problem, Solution& found);

/// Tells whether the candidates leave it in doubt which pose is right.
bool is_doubtful(const Problem& problem, const Solution& found);

/// Tells whether the pose is one that surfaces seldom have and wrong poses often: degenerate, or
/// better mirrored or scaled. Then a search with fewer points may have missed the right one.
bool is_strange(const Solution& found);

/// Tells whether the settings ask for a second search of a pose that is doubtful.
bool needs_fallback_search(const Problem& problem, const Solution& found);

/// Tells whether they ask for one where the refined pose is strange.
bool needs_second_look(const Problem& problem, const Solution& found);

/// Searches again with more feature points, and ranks all candidates anew.
void search_again(const Problem& problem, Solution& found);

/// Refines the best pose on the fine clouds.
void refine_pose(const Problem& problem, Solution& found);

/// Where the surfaces leave directions unconstrained, estimates the confidence that the pose is
/// right but for a motion along these.
void believe_but_for_unconstrained(const Problem& problem, Solution& found);

/// Where the settings ask for it, looks for the pose at which the colors agree too: among the
/// candidates, and along the directions that the surfaces leave unconstrained. If the colors prove
/// one, it is the answer, refined by shape and colors, and judged by both.
void resolve_by_colors(const Problem& problem, Solution& found);

/// Finds the self-symmetry of the clouds, by the candidates and the refined surfaces.
void recognize_symmetry(Solution& found);

/// Measures on the fine clouds how much of each cloud lies on the other, and lowers the confidence
/// where the refined surfaces do not lie flush.
void measure_overlap(const Problem& problem, Solution& found);

/// Lowers the confidence of a pose that would be called registered where the source fits better
/// mirrored or at another scale.
void weigh_changed_source(const Problem& problem, Solution& found);

/// Estimates the confidence in the first of these candidates.
void believe(const Problem& problem, const std::vector<Candidate>& ranked, Solution& found);

/// Returns the fine surfaces, made when first asked for.
const FineSurfaces& fine(const Problem& problem, Solution& found);

/// Takes the best pose that is known when a stage was stopped, if any is.
void take_best_so_far(const Problem& problem, Solution& found);

/// Judges the pose by task alpha's fitness. The seconds count as the verdict's.
void judge_pose(const Problem& problem, Solution& found);

}  // namespace emtr
