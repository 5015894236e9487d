#pragma once

#include <emtr/emtr.h>

namespace cli {

/// Shows on one line of a terminal how far the run is, and erases the line when it ends. Prints
/// nothing when quiet or when standard error is not a terminal.
class ProgressLine {
 public:
  explicit ProgressLine(bool quiet);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(const emtr_progress& progress);

 private:
  bool active_;
  double last_ = -1;  // when the line was printed, in seconds; -1: never
};

}  // namespace cli
