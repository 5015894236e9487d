#pragma once

#include <memory>

#include "candidates/pool.h"
#include "problem.h"
#include "verdict/standing.h"

namespace emtr {

/// The way from a problem to a result: evolution from the seeds, candidates from both, escalation
/// when they do not convince, refinement of the best, verdict.
class Registration {
 public:
  Registration(const Problem& problem, const OnProgress& on_progress);

  std::unique_ptr<Result> run();

 private:
  bool stop(const char* stage);  ///< asks the caller
  void describe_problem();
  std::vector<Rigid> starts();
  Evolution evolve();
  void rank(const Evolution& evolution);
  void conclude(const Evolution& evolution);

  const Problem& problem_;
  const Settings& settings_;
  const OnProgress& on_progress_;
  std::unique_ptr<Result> result_;
  std::unique_ptr<Pool> pool_;
  std::vector<Rigid> shortlist_;  ///< the best seeds
  Rigid answer_;  ///< normalised frame
  Standing standing_;
  bool stopped_ = false;
};

}  // namespace emtr
