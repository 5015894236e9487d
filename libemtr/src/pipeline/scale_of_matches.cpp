#include "pipeline/scale_of_matches.h"

#include <algorithm>
#include <cmath>

#include "correspondences/user_correspondences.h"
#include "seeds/chance.h"
#include "seeds/match_pose.h"
#include "tasks/task_gamma.h"

namespace emtr {
namespace {

using Eigen::Vector3d;

// Noise that the votes allow for, over the usual length between two matches.
constexpr double kWidths[] = {0.005, 0.02, 0.07};
constexpr std::size_t kPeaks = 4;             // of each width
constexpr std::size_t kVotingMatches = 2000;  // more would take the time of their square

}  // namespace

std::optional<ScaleHypothesis> scale_of_matches(const InputCloud& source, const InputCloud& target,
                                                const ScaleRange& range, const Settings& settings) {
  const NormalizedPair pair =
      normalize(source.preprocessed->rescaled(range.guess), target.preprocessed);
  const UserCorrespondences user =
      load_user_correspondences(pair, settings.correspondences, settings.correspondence_count,
                                static_cast<std::size_t>(settings.max_correspondences));
  const MatchPoints& all = user.matches;
  std::vector<std::uint32_t> some;
  const std::size_t step = (all.size() + kVotingMatches - 1) / kVotingMatches;
  for (std::size_t i = 0; i < all.size(); i += step) some.push_back(static_cast<std::uint32_t>(i));
  const MatchPoints voting = all.select(some);
  const int threads = thread_count(settings);
  const Kernels& kernels = select_kernels();
  const double length = Chance(all).usual_length();

  std::optional<ScaleHypothesis> best;
  double least_chance = 0;
  for (const double width : kWidths) {
    TaskGamma gamma(range.lowest, range.highest);
    const double middle = (range.lowest + range.highest) / 2;
    // Without descriptors no scale is likelier than another: a window that is flat over the range.
    gamma.add(voting, width * length, 0, 4 * (std::abs(middle) + range.highest - range.lowest),
              threads);
    for (const TaskGamma::Peak& peak : gamma.peaks(kPeaks)) {
      check_cancelled();
      const double scale = std::exp2(peak.octaves);
      const MatchPoints rescaled{scale_cloud(all.p, scale), all.q};
      const MatchPose found = find_match_poses(rescaled, kernels, threads).front();
      if (!(found.log_chance < least_chance)) continue;
      least_chance = found.log_chance;
      Similarity similarity = pair.normalization.to_user(Similarity{scale, found.pose});
      similarity.scale *= range.guess;
      best = {similarity,
              static_cast<double>(found.inliers.size()) / static_cast<double>(all.size())};
    }
  }
  return best;
}

Similarity fit_similarity(const Problem& problem, const Rigid& pose) {
  const MatchPoints& matches = problem.user_matches.matches;
  const auto& inliers = problem.match_poses.front().inliers;
  if (inliers.size() < 3) return {1, pose};
  const double n = static_cast<double>(inliers.size());
  Vector3d p_mean = Vector3d::Zero(), q_mean = Vector3d::Zero();
  for (const std::uint32_t i : inliers) {
    p_mean += point_of(matches.p, i) / n;
    q_mean += point_of(matches.q, i) / n;
  }
  double both = 0, squares = 0;
  for (const std::uint32_t i : inliers) {
    const Vector3d p = point_of(matches.p, i) - p_mean, q = point_of(matches.q, i) - q_mean;
    both += q.dot(pose.rotate(p));
    squares += p.squaredNorm();
  }
  const double scale = squares > 0 && both > 0 ? both / squares : 1;
  return {scale, {pose.R, q_mean - scale * pose.rotate(p_mean)}};
}

}  // namespace emtr
