#pragma once

#include <optional>
#include <vector>

#include "../rigid.h"
#include "../team.h"
#include "surfaces.h"

namespace emtr {

/// A pose that may be the answer.
struct Candidate {
  Rigid pose;  ///< normalised frame
  FitValue fit;
  double violation = 0;  ///< of free space, 0 when nothing is known of it
  double score = 0;      ///< chf - 2 violations, higher is better
};

inline const Rigid& pose_of(const Candidate& candidate) { return candidate.pose; }

/// The poses from all sources (seeds, the swarm, escalation, the caller) in one ranking: a little
/// polish each, then the fine score. Distinct ones, best first.
class Pool {
 public:
  /// Both must outlive the pool. With a prior all poses are to keep to it, and do so when polished.
  Pool(const Surfaces& surfaces, const Prior* prior) : surfaces_(surfaces), prior_(prior) {}

  /// The `most` poses with the best quick score that are no copies of each other, best first.
  std::vector<Rigid> shortlist(const std::vector<Rigid>& poses, std::size_t most, Team& team) const;

  /// Polishes and scores them, and takes them in; when stopped, those that were done by then.
  void add(const std::vector<Rigid>& poses, Team& team);

  const std::vector<Candidate>& ranked() const { return ranked_; }

 private:
  struct Scratch {
    Ranking::Scratch ranking;
    LocalPolish::Scratch polish;
  };
  void take_in(const std::vector<std::optional<Candidate>>& fresh);
  Candidate judged(const Rigid& start, Scratch& scratch) const;

  const Surfaces& surfaces_;
  const Prior* prior_;
  std::vector<Candidate> ranked_;
};

}  // namespace emtr
