#pragma once

#include <memory>
#include <optional>

#include "candidates/candidate_search.h"
#include "pipeline/problem.h"
#include "refinement/refine.h"
#include "verdict/confidence.h"

namespace emtr {

/// The way from a problem to a result: evolution from the seeds, candidates from both, fallback search
/// when they do not convince, refinement of the best, verdict.
class Registration {
 public:
  Registration(const Problem& problem, CancellationToken& watch);

  std::unique_ptr<Result> run();

 private:
  void search();                  ///< all that finds poses; Stopped leaves the best so far
  void enter(const char* stage);  ///< tells the caller
  void describe_problem();
  Starts starts() const;
  void evolve();
  void rank();
  void settle();   ///< on the best candidate
  void salvage();  ///< what is known of the best pose when the work was stopped in its midst
  bool unsure() const;
  const FineSurfaces& fine();
  void refine();
  void conclude();
  void conclude_candidates();
  void conclude_refinement();
  void conclude_overlap();
  std::vector<Rigid> guess() const;
  Rigid admitted(const Rigid& pose) const;  ///< or the nearest that a prior admits

  const Problem& problem_;
  const Settings& settings_;
  const Prior* prior_;  ///< null when every pose is admissible
  CancellationToken& watch_;
  std::unique_ptr<Result> result_;
  std::unique_ptr<CandidateSearch> search_;  ///< null when none are asked for
  std::vector<Rigid> shortlist_;             ///< the best seeds
  Evolution evolution_;
  std::optional<Rigid> answer_;  ///< normalized frame; the best pose so far
  Confidence confidence_;
  bool ranked_ = false;  ///< whether all candidates are, so that the standing means something
  std::unique_ptr<FineSurfaces> fine_;  ///< made when first asked for
  Refined refined_;
  bool stopped_ = false;
};

}  // namespace emtr
