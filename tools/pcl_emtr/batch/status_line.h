#pragma once

#include <cstddef>
#include <mutex>
#include <string>

#include "batch/record_file.h"

namespace cli {

/// Shows on one line of a terminal how many pairs are done, how many per second, and the time that
/// is left, and erases the line when it ends. Prints no such line when quiet or when standard error
/// is not a terminal. Threads may share it.
class StatusLine {
 public:
  /// `before`: how many of the pairs are recorded already.
  StatusLine(bool quiet, std::size_t pairs, std::size_t before);
  ~StatusLine();
  StatusLine(const StatusLine&) = delete;
  StatusLine& operator=(const StatusLine&) = delete;

  void show(const RecordFile::Counts& counts);
  void warning(const std::string& text);

 private:
  const bool active_;
  const std::size_t pairs_, before_;
  const double begin_;
  double last_ = 0;  // when the line was printed, in seconds
  std::mutex mutex_;
};

}  // namespace cli
