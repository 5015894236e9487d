#pragma once

#include <optional>

#include "pipeline/problem.h"
#include "ranking/viewpoint.h"

namespace emtr {

// The steps of make_problem(). Each reads what the ones before it have put into the problem, and
// fills in its own part.

/// Reads the user's correspondences, where there are some. Throws Error when they cannot be used.
void load_user_matches(const Settings& user, Problem& problem);

/// Finds the poses that the user's matches agree on, and tells whether they decide: where the
/// clouds are no surfaces, or are little more than the ends of matches that agree beyond doubt.
void find_match_poses(Problem& problem);

/// Takes keypoints from the user, where there are some, or those that the matches name. Throws
/// Error when they cannot be used.
void load_user_keypoints(Problem& problem);

/// Computes normals and, unless the user provides keypoints, descriptors of the dense clouds.
void describe_clouds(Problem& problem);

/// Finds correspondences, unless the user provides them, and forms TIMs of the best.
void match_clouds(Problem& problem);

/// Where the sensors stood, as far as that is known.
struct Viewpoints {
  std::optional<Viewpoint> source, target;
};

/// Returns the user's or, where free space counts, estimates.
Viewpoints find_viewpoints(const Problem& problem);

/// Makes both tasks and the knowledge complement, for as many evaluations as a solution mostly
/// needs or, for Stages::All, as all iterations make; and when the settings ask for candidates, the
/// surfaces on which these are ranked.
void make_tasks_and_surfaces(const Viewpoints& viewpoints, Stages stages, Problem& problem);

/// Finds the poses that consistent correspondences agree on.
void find_seeds(Problem& problem);

}  // namespace emtr
