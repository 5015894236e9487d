#pragma once

#include <optional>

#include "pipeline/stage_seconds.h"
#include "util/cancellation.h"
#include "util/stage.h"
#include "util/stopwatch.h"

namespace emtr {

/// Leads a run from stage to stage: tells the caller which stage begins, and measures how long each
/// one takes.
class Progress {
 public:
  /// `iterations`: how many the evolution will make, 0 while nobody asks for it. The token and the
  /// seconds must outlive the progress.
  Progress(CancellationToken& token, int iterations, StageSeconds& seconds)
      : token_(token), iterations_(iterations), seconds_(seconds) {}
  ~Progress() { leave(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Ends the stage before and begins this one. Throws Cancelled when the run is to end.
  void enter(Stage stage);

  /// Tells the caller that an iteration of the evolution is done. Returns true when the run is to
  /// end.
  bool iterated(int done, double best_alpha, double best_beta);

 private:
  void leave();

  CancellationToken& token_;
  const int iterations_;
  StageSeconds& seconds_;
  std::optional<Stage> stage_;
  Stopwatch stopwatch_;
};

}  // namespace emtr
