#include "candidates/candidate_set.h"

#include <algorithm>
#include <numeric>

#include "geometry/pose_distance.h"

namespace emtr {

namespace {

constexpr double kOnePlace = 6;      // leaves, from sensor to sensor
constexpr double kSamePoints = 0.5;  // of all points

bool from_one_place(const SurfacePair& surfaces, const Rigid& pose) {
  const auto &source = surfaces.source_viewpoint(), &target = surfaces.target_viewpoint();
  const auto is_known = [](const std::optional<Viewpoint>& v) { return v && v->trust == 1; };
  if (!is_known(source) || !is_known(target)) return false;
  const Eigen::Vector3d moved = pose * Eigen::Vector3d::Map(source->at);
  return (moved - Eigen::Vector3d::Map(target->at)).norm() < kOnePlace * surfaces.source().leaf;
}

}  // namespace

std::vector<Rigid> CandidateSet::shortlist(const std::vector<Rigid>& poses,
                                           std::size_t maximum_count, ThreadTeam& team) const {
  std::vector<double> quick(poses.size());
  std::vector<Ranking::Scratch> scratch(team.size());
  team.parallel(poses.size(), [&](std::size_t i, std::size_t thread) {
    quick[i] =
        surfaces_.ranking().evaluate(poses[i], scratch[thread], SurfacePair::kQuickStep).score;
  });
  std::vector<std::size_t> order(poses.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return quick[a] > quick[b]; });
  std::vector<Rigid> sorted;
  sorted.reserve(poses.size());
  for (const std::size_t i : order) sorted.push_back(poses[i]);
  return suppress_non_maxima(sorted, kDuplicatePose, maximum_count);
}

void CandidateSet::add(const std::vector<Rigid>& poses, ThreadTeam& team) {
  std::vector<std::optional<Candidate>> candidates(poses.size());
  std::vector<Scratch> scratch(team.size());
  try {
    team.parallel(poses.size(), [&](std::size_t i, std::size_t thread) {
      candidates[i] = evaluate(poses[i], scratch[thread]);
    });
  } catch (const Cancelled&) {
    merge(candidates);
    throw;
  }
  merge(candidates);
}

void CandidateSet::merge(const std::vector<std::optional<Candidate>>& candidates) {
  for (const auto& candidate : candidates)
    if (candidate) ranked_.push_back(*candidate);
  std::stable_sort(ranked_.begin(), ranked_.end(),
                   [](const Candidate& a, const Candidate& b) { return a.score > b.score; });
  ranked_ = suppress_non_maxima(ranked_, kDuplicatePose, ranked_.size());
}

Candidate CandidateSet::evaluate(const Rigid& start, Scratch& scratch) const {
  const Ranking& ranking = surfaces_.ranking();
  const auto quick = [&](const Rigid& pose) {
    return ranking.evaluate(pose, scratch.ranking, SurfacePair::kQuickStep).score;
  };
  Rigid pose = surfaces_.local_refinement()(start, prior_, scratch.refinement).pose;
  if (quick(pose) < quick(start)) pose = start;  // refinement can run off along a plane
  return score(pose, scratch.ranking);
}

Candidate CandidateSet::score(const Rigid& pose, Ranking::Scratch& scratch) const {
  const Ranking::Value value = surfaces_.ranking().evaluate(pose, scratch);
  return {pose, value.fit, value.violation, value.score,
          value.fit.same_points > kSamePoints || from_one_place(surfaces_, pose)};
}

void CandidateSet::put_first(const Candidate& candidate) {
  ranked_.insert(ranked_.begin(), candidate);
  ranked_ = suppress_non_maxima(ranked_, kDuplicatePose, ranked_.size());
}

}  // namespace emtr
