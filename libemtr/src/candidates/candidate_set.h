#pragma once

#include <optional>
#include <vector>

#include "candidates/surface_pair.h"
#include "geometry/rigid.h"
#include "util/thread_team.h"

namespace emtr {

/// A pose that may be the answer.
struct Candidate {
  Rigid pose;  ///< normalized frame
  SurfaceFitValue fit;
  double violation = 0;  ///< of free space, 0 when nothing is known of it
  double score = 0;      ///< see Ranking::Value; higher is better
  /// Whether both clouds have the same pattern of points under this pose: both scanners stood in
  /// one place, or the points are the same. The pattern lies on itself whatever the shape, so the
  /// score says less.
  bool shares_pattern = false;
};

inline const Rigid& pose_of(const Candidate& candidate) { return candidate.pose; }

/// Ranks the poses from all sources (seeds, the swarm, fallback search, the user): a short local
/// refinement of each, then the fine score. No two of them are the same pose; the best is first.
class CandidateSet {
 public:
  /// The best of a fallback search was among the first twenty of two hundred on 21 real pairs.
  static constexpr std::size_t kMost = 40;

  /// Both must outlive the set. With a prior all poses added are to be admissible; refinement then
  /// keeps them so.
  CandidateSet(const SurfacePair& surfaces, const Prior* prior)
      : surfaces_(surfaces), prior_(prior) {}

  /// Returns the poses with the best quick scores, at most `maximum_count` and no two of them
  /// duplicates, best first.
  std::vector<Rigid> shortlist(const std::vector<Rigid>& poses, std::size_t maximum_count,
                               ThreadTeam& team) const;

  /// Refines and scores the poses and ranks them among the others; when cancelled, those that were
  /// done by then. The first part of the refinement, of few queries, tells which of them end in
  /// one place, and which do not deserve the rest: all but the `most` best by their quick scores.
  void add(const std::vector<Rigid>& poses, ThreadTeam& team, std::size_t most = kMost);

  /// Scores a pose as it is.
  Candidate score(const Rigid& pose, Ranking::Scratch& scratch) const;

  /// Puts a candidate before all others, whatever its score, and drops those of the same pose.
  void put_first(const Candidate& candidate);

  const std::vector<Candidate>& ranked() const { return ranked_; }

 private:
  struct Scratch {
    Ranking::Scratch ranking;
    LocalRefinement::Scratch refinement;
  };
  /// A start after the first part of its refinement, which tells duplicates.
  struct Approached {
    Rigid start;
    LocalRefinementResult approached;
    double quick_score;
  };
  friend const Rigid& pose_of(const Approached& pose) { return pose.approached.pose; }

  std::vector<Approached> approach(const std::vector<Rigid>& starts, std::size_t most,
                                   std::vector<Scratch>& scratch, ThreadTeam& team) const;
  Candidate evaluate(const Approached& pose, Scratch& scratch) const;
  void merge(const std::vector<std::optional<Candidate>>& candidates);

  const SurfacePair& surfaces_;
  const Prior* prior_;
  std::vector<Candidate> ranked_;
};

}  // namespace emtr
