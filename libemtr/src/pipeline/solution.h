#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "candidates/candidate_search.h"
#include "colors/color_comparison.h"
#include "evolution/engine.h"
#include "pipeline/stage_seconds.h"
#include "refinement/fine_surfaces.h"
#include "refinement/refine.h"
#include "verdict/confidence.h"
#include "verdict/match_verdict.h"
#include "verdict/overlap.h"
#include "verdict/symmetry.h"
#include "verdict/verdict.h"

namespace emtr {

/// The findings of the search so far, also those of a run that was stopped.
struct Solution {
  std::optional<Rigid> pose;  ///< the best so far, normalized frame

  std::vector<Rigid> shortlist;                 ///< the best seeds
  std::unique_ptr<CandidateSearch> candidates;  ///< null when the settings ask for none
  Evolution evolution;
  std::optional<Confidence> confidence;  ///< empty until all candidates are ranked
  std::unique_ptr<FineSurfaces> fine;    ///< null until a stage needs them
  Refined refined;
  bool moves_freely = false;  ///< the pose may move along its unconstrained directions, however far
  bool compared_colors = false;  ///< whether there are colors that tell something is known
  std::unique_ptr<ColorComparison> colors;      ///< null where none tell anything
  std::optional<ColorEvidence> color_evidence;  ///< of the pose; empty if they were not looked at
  bool used_colors = false;                     ///< the pose is the one that they decided for
  std::optional<Symmetry> symmetry;             ///< empty until all candidates are ranked
  std::optional<Overlap> overlap;
  std::optional<Verdict> verdict;             ///< empty when no pose is known
  std::optional<MatchVerdict> match_verdict;  ///< where the matches decide

  StageSeconds seconds;
  bool stopped = false;
};

}  // namespace emtr
