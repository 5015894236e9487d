#include "batch/status_line.h"

#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdio>

#include "console/messages.h"
#include "console/terminal.h"

namespace cli {
namespace {

constexpr double kEvery = 0.1;  // seconds

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Prints a time as 1:02:03, or 2:03 below an hour.
std::string clock_text(double seconds) {
  const auto whole = static_cast<long long>(std::ceil(seconds));
  char text[40];
  if (whole >= 3600)
    std::snprintf(text, sizeof text, "%lld:%02lld:%02lld", whole / 3600, whole / 60 % 60,
                  whole % 60);
  else
    std::snprintf(text, sizeof text, "%lld:%02lld", whole / 60, whole % 60);
  return text;
}

}  // namespace

StatusLine::StatusLine(bool quiet, std::size_t pairs, std::size_t before)
    : active_(!quiet && isatty(STDERR_FILENO) && !is_dumb_terminal()),
      pairs_(pairs),
      before_(before),
      begin_(now()) {}

StatusLine::~StatusLine() {
  if (active_) std::fputs("\r\033[K", stderr);
}

void StatusLine::show(const RecordFile::Counts& counts) {
  if (!active_) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  const double at = now();
  if (at - last_ < kEvery) return;
  last_ = at;
  const std::size_t done = counts.all();
  std::fprintf(stderr, "\r\033[K%zu/%zu pairs", done, pairs_);
  if (done > before_) {
    const double rate = static_cast<double>(done - before_) / (at - begin_);
    std::fprintf(stderr, ", %.3g pairs/s, %s left", rate,
                 clock_text(static_cast<double>(pairs_ - done) / rate).c_str());
  }
  if (counts.errors) std::fprintf(stderr, ", %zu errors", counts.errors);
  std::fflush(stderr);
}

void StatusLine::warning(const std::string& text) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (active_) std::fputs("\r\033[K", stderr);
  Messages(false).warning(text);
  last_ = 0;
}

}  // namespace cli
