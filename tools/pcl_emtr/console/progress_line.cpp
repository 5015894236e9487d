#include "console/progress_line.h"

#include <unistd.h>

#include <chrono>
#include <cstdio>

#include "console/terminal.h"

namespace cli {

ProgressLine::ProgressLine(bool quiet)
    : active_(!quiet && isatty(STDERR_FILENO) && !is_dumb_terminal()) {}

ProgressLine::~ProgressLine() {
  if (active_ && last_ >= 0) std::fputs("\r\033[K", stderr);
}

void ProgressLine::show(const emtr_progress& progress) {
  if (!active_) return;
  const double now =
      std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  const bool first = progress.iteration == 0;  // the beginning of a stage is always shown
  if (!first && now - last_ < 0.05) return;
  last_ = now;
  std::fprintf(stderr, "\r\033[K%s", progress.stage);
  if (!first)
    std::fprintf(stderr, " %d/%d  best alpha %.5g  best beta %.5g", progress.iteration,
                 progress.iterations, progress.best_alpha, progress.best_beta);
  std::fflush(stderr);
}

}  // namespace cli
