#include <algorithm>

#include "neighbors/flat_share.h"
#include "pipeline/problem_stages.h"
#include "util/error.h"

namespace emtr {
namespace {

constexpr std::size_t kFewPoints = 100;  // that are no surface
constexpr double kFlatShare = 0.15;  // points scattered in space have 0.02, the noisiest scans more
constexpr double kBeyondDoubt = -8;  // decimal logarithm of how often chance does it

bool is_surface(const Cloud& cloud) {
  return cloud.size() >= kFewPoints && flat_share(cloud) >= kFlatShare;
}

/// Tells whether at least half of the points of both clouds are ends of matches.
bool are_keypoints(const Problem& problem) {
  return 2 * problem.user_matches.named_source >= problem.pair.preprocessed_source->count &&
         2 * problem.user_matches.named_target >= problem.pair.preprocessed_target->count;
}

/// Moves the best pose to the nearest one that the prior admits, and asks the matches about that.
void keep_to_prior(Problem& problem) {
  if (!problem.prior) return;
  const MatchPoints& matches = problem.user_matches.matches;
  MatchPose& best = problem.match_poses.front();
  const Rigid admitted = problem.prior->project(best.pose);
  const auto fits = [&](std::uint32_t i) {
    return distance(admitted * point_of(matches.p, i), point_of(matches.q, i)) <= best.threshold;
  };
  if (std::all_of(best.inliers.begin(), best.inliers.end(), fits))
    best.pose = admitted;
  else
    problem.match_poses = {rate_match_pose(matches, admitted)};
}

}  // namespace

void load_user_matches(const Settings& user, Problem& problem) {
  if (!user.correspondences && user.correspondence_count == 0) return;
  if (!user.correspondences)
    throw Error(EMTR_ERROR_ARGUMENT, "correspondences: null, but correspondence_count is not 0");
  problem.user_matches =
      load_user_correspondences(problem.pair, user.correspondences, user.correspondence_count,
                                static_cast<std::size_t>(problem.settings.max_correspondences));
  problem.correspondences = problem.user_matches.correspondences;
  problem.correspondences_found = user.correspondence_count;
}

void find_match_poses(Problem& problem) {
  const MatchPoints& matches = problem.user_matches.matches;
  problem.match_poses = find_match_poses(matches, problem.kernels, thread_count(problem.settings));
  keep_to_prior(problem);
  const bool beyond_doubt =
      problem.match_poses.size() == 1 && problem.match_poses.front().log_chance < kBeyondDoubt;
  problem.matches_decide = (beyond_doubt && are_keypoints(problem)) ||
                           !is_surface(problem.pair.source) || !is_surface(problem.pair.target);
}

}  // namespace emtr
