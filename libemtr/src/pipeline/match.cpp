#include <algorithm>
#include <vector>

#include "correspondences/user_correspondences.h"
#include "neighbors/resolution.h"
#include "pipeline/problem_stages.h"

namespace emtr {
namespace {

/// Tells whether the correspondences are ordered by the distance between descriptors; those of the
/// user are in an order that means nothing.
bool ordered_by_distance(const Problem& problem) {
  return !problem.user_keypoints || problem.user_keypoints->source.dimension;
}

void find_correspondences(Problem& problem) {
  const auto match_descriptors = [&](const DescriptorRows& source, const DescriptorRows& target) {
    problem.correspondences =
        match(source, target, static_cast<std::size_t>(problem.settings.max_correspondences),
              problem.kernels, thread_count(problem.settings), &problem.correspondences_found);
  };
  if (!problem.user_keypoints)
    match_descriptors(*problem.source_features, *problem.target_features);
  else if (problem.user_keypoints->source.dimension)
    match_descriptors(problem.user_keypoints->source, problem.user_keypoints->target);
}

double tau_of(const Problem& problem) {
  const auto resolution_of = [&](const Cloud& cloud) {
    return mean_resolution(cloud, problem.downsampled.leaf_dense, problem.kernels,
                           thread_count(problem.settings));
  };
  const double resolution = (resolution_of(problem.downsampled.source_dense) +
                             resolution_of(problem.downsampled.target_dense)) /
                            2;
  return problem.settings.tau_factor * resolution;
}

/// Returns the correspondences that the tasks are made of, enough for max_tims pairs: the best, or,
/// where the order means nothing, some from all over the list. Seeds are made of all.
std::vector<Correspondence> correspondences_for_tims(const Problem& problem) {
  const std::vector<Correspondence>& all = problem.correspondences;
  const std::size_t count =
      std::min(all.size(), correspondence_cap(static_cast<std::size_t>(problem.settings.max_tims)));
  if (!ordered_by_distance(problem)) return select_evenly(all, count);
  return {all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count)};
}

}  // namespace

void match_clouds(Problem& problem) {
  find_correspondences(problem);
  problem.tau = tau_of(problem);
  problem.tims = form_tims(problem.matched_source(), problem.matched_target(),
                           correspondences_for_tims(problem),
                           TaskBeta::threshold(problem.tau, problem.settings));
}

void find_seeds(Problem& problem) {
  const Settings& settings = problem.settings;
  const int threads = thread_count(settings);
  const double threshold = settings.seed_threshold * problem.downsampled.leaf_dense;
  const Consistency consistency(problem.matched_source(), problem.matched_target(),
                                problem.correspondences, threshold, problem.kernels, threads);
  problem.seeds =
      find_seeds(consistency, threshold, static_cast<std::size_t>(settings.seeds), threads);
}

}  // namespace emtr
