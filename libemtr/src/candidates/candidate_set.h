#pragma once

#include <optional>
#include <vector>

#include "geometry/rigid.h"
#include "util/thread_team.h"
#include "candidates/surface_pair.h"

namespace emtr {

/// A pose that may be the answer.
struct Candidate {
  Rigid pose;  ///< normalized frame
  SurfaceFitValue fit;
  double violation = 0;  ///< of free space, 0 when nothing is known of it
  double score = 0;      ///< chf - 2 violations, higher is better
};

inline const Rigid& pose_of(const Candidate& candidate) { return candidate.pose; }

/// The poses from all sources (seeds, the swarm, fallback search, the caller) in one ranking: a little
/// polish each, then the fine score. Distinct ones, best first.
class CandidateSet {
 public:
  /// Both must outlive the pool. With a prior all poses are to keep to it, and do so when polished.
  CandidateSet(const SurfacePair& surfaces, const Prior* prior) : surfaces_(surfaces), prior_(prior) {}

  /// The `most` poses with the best quick score that are no copies of each other, best first.
  std::vector<Rigid> shortlist(const std::vector<Rigid>& poses, std::size_t most, ThreadTeam& team) const;

  /// Polishes and scores them, and takes them in; when stopped, those that were done by then.
  void add(const std::vector<Rigid>& poses, ThreadTeam& team);

  const std::vector<Candidate>& ranked() const { return ranked_; }

 private:
  struct Scratch {
    Ranking::Scratch ranking;
    LocalRefinement::Scratch local_refinement;
  };
  void take_in(const std::vector<std::optional<Candidate>>& fresh);
  Candidate judged(const Rigid& start, Scratch& scratch) const;

  const SurfacePair& surfaces_;
  const Prior* prior_;
  std::vector<Candidate> ranked_;
};

}  // namespace emtr
