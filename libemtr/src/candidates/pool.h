#pragma once

#include <vector>

#include "../team.h"
#include "../ranking/fit.h"
#include "../refinement/local_polish.h"
#include "../rigid.h"

namespace emtr {

/// A pose that may be the answer.
struct Candidate {
  Rigid pose;  ///< normalised frame
  FitValue fit;
  double violation = 0;  ///< of free space, 0 when nothing is known of it
  double score = 0;      ///< chf - 2 violations, higher is better
};

/// The poses from all sources (seeds, the swarm, escalation, the caller) in one ranking: a little
/// polish each, then the fine score. Distinct ones, best first.
class Pool {
 public:
  /// Share of space violated under a pose; empty when free space is not to count.
  using Violation = std::function<double(const Rigid& pose, const FitValue& fit)>;

  /// All arguments must outlive the pool. `step`: the shortlist looks at every step-th point.
  Pool(const Fit& fit, std::size_t step, const LocalPolish& polish, Violation violation);

  /// The `most` poses with the best quick fit that are no copies of each other, best first.
  std::vector<Rigid> shortlist(const std::vector<Rigid>& poses, std::size_t most, Team& team) const;

  /// Polishes and scores them, and takes them in.
  void add(const std::vector<Rigid>& poses, Team& team);

  const std::vector<Candidate>& ranked() const { return ranked_; }

 private:
  Candidate judged(const Rigid& start, Fit::Scratch& fit, LocalPolish::Scratch& polish) const;

  const Fit& fit_;
  std::size_t step_;
  const LocalPolish& polish_;
  Violation violation_;
  std::vector<Candidate> ranked_;
};

}  // namespace emtr
