#pragma once

#include <emtr/emtr.h>

#include <string>

#include "cloud_file.h"

namespace cli {

// Everything said to a person, in the look of PCL's tools. It all goes to standard error, so
// that standard output holds the matrix and nothing else.

/// Says nothing when quiet, but for warnings.
class Talk {
 public:
  explicit Talk(bool quiet) : quiet_(quiet) {}

  void loaded(const CloudFile& cloud) const;
  void registered(const emtr_result& result) const;
  void verdict(const emtr_result& result) const;
  void saved(const std::string& path, const std::string& what) const;
  void warning(const std::string& text) const;

 private:
  bool quiet_;
};

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
