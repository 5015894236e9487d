#include "candidates/candidate_set.h"

#include <algorithm>

#include "candidates/quick_scores.h"
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
  std::vector<Rigid> sorted;
  sorted.reserve(poses.size());
  for (const std::size_t i : order_by_quick_scores(surfaces_, poses, maximum_count, team))
    sorted.push_back(poses[i]);
  return suppress_non_maxima(sorted, kDuplicatePose, maximum_count);
}

void CandidateSet::add(const std::vector<Rigid>& poses, ThreadTeam& team, std::size_t most) {
  std::vector<Scratch> scratch(team.size());
  const std::vector<Approached> distinct = approach(poses, most, scratch, team);
  std::vector<std::optional<Candidate>> candidates(distinct.size());
  try {
    team.parallel(distinct.size(), [&](std::size_t i, std::size_t thread) {
      candidates[i] = evaluate(distinct[i], scratch[thread]);
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

std::vector<CandidateSet::Approached> CandidateSet::approach(const std::vector<Rigid>& starts,
                                                             std::size_t most,
                                                             std::vector<Scratch>& scratch,
                                                             ThreadTeam& team) const {
  std::vector<Approached> out(starts.size());
  team.parallel(starts.size(), [&](std::size_t i, std::size_t thread) {
    Scratch& s = scratch[thread];
    out[i] = {starts[i], surfaces_.local_refinement().approach(starts[i], prior_, s.refinement), 0};
    out[i].quick_score = quick_score(surfaces_, out[i].approached.pose, s.ranking);
  });
  std::stable_sort(out.begin(), out.end(), [](const Approached& a, const Approached& b) {
    return a.quick_score > b.quick_score;
  });
  return suppress_non_maxima(out, kDuplicatePose, most);
}

Candidate CandidateSet::evaluate(const Approached& pose, Scratch& scratch) const {
  Rigid end = surfaces_.local_refinement()
                  .finish(pose.start, pose.approached, prior_, scratch.refinement)
                  .pose;
  // Refinement can run off along a plane.
  if (quick_score(surfaces_, end, scratch.ranking) <
      quick_score(surfaces_, pose.start, scratch.ranking))
    end = pose.start;
  return score(end, scratch.ranking);
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
