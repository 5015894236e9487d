#pragma once

#include <emtr/emtr.h>

namespace cli {

/// One line on a terminal that tells how far the run is; erased when it ends. Silent when quiet
/// or when standard error is no terminal.
class ProgressLine {
 public:
  explicit ProgressLine(bool quiet);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(const emtr_progress& progress);

 private:
  bool active_;
  double last_ = -1;  // seconds
};

}  // namespace cli
