#pragma once

#include <memory>

#include "candidates/search.h"
#include "problem.h"
#include "refinement/refine.h"
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
  std::vector<Rigid> starts() const;
  Evolution evolve();
  void rank(const Evolution& evolution);
  void settle();  ///< on the best candidate
  bool unsure() const;
  const FineSurfaces& fine();
  void refine();
  void conclude(const Evolution& evolution);
  void conclude_candidates();
  void conclude_refinement();
  void conclude_agreement();
  std::vector<Rigid> guess() const;

  const Problem& problem_;
  const Settings& settings_;
  const Prior* prior_;  ///< null when every pose is admissible
  const OnProgress& on_progress_;
  std::unique_ptr<Result> result_;
  std::unique_ptr<CandidateSearch> search_;  ///< null when none are asked for
  std::vector<Rigid> shortlist_;             ///< the best seeds
  Rigid answer_;                             ///< normalised frame
  Standing standing_;
  std::unique_ptr<FineSurfaces> fine_;  ///< made when first asked for
  Refined refined_;
  bool stopped_ = false;
};

}  // namespace emtr
