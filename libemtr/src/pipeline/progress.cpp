#include "pipeline/progress.h"

namespace emtr {

void Progress::enter(Stage stage) {
  leave();
  if (token_.report_progress({stage_name(stage), 0, iterations_, 0, 0})) throw Cancelled();
  stopwatch_.lap();  // the caller's own time is no stage's
  stage_ = stage;
}

bool Progress::iterated(int done, double best_alpha, double best_beta) {
  return token_.report_progress(
      {stage_name(Stage::Evolution), done, iterations_, best_alpha, best_beta});
}

void Progress::leave() {
  if (stage_) seconds_[*stage_] += stopwatch_.lap();
  stage_.reset();
}

}  // namespace emtr
