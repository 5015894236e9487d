#pragma once

#include <emtr/emtr.h>

#include <atomic>
#include <chrono>
#include <functional>

#include "util/stage.h"

namespace emtr {

/// Tells the caller how far the run is. Returning true stops the run.
using OnProgress = std::function<bool(const emtr_progress&)>;

/// Thrown out of the midst of the work when the run is cancelled; caught by the owner of the best
/// pose so far.
struct Cancelled {};

/// Reports the progress of one run to its caller, and cancels the run when the caller or the time
/// limit says so. All work calls check_cancelled() at least every few milliseconds, on whichever
/// thread. The clock decides how often the caller is asked, so no result depends on it.
class CancellationToken {
 public:
  using Clock = std::chrono::steady_clock;

  /// Limits the run to `seconds` from now on, 0 for no limit. Asks the caller once in `interval`: a
  /// cancellation takes this long and one piece of work. Only the thread that made the token may
  /// call its methods that are not const.
  explicit CancellationToken(OnProgress on_progress, double seconds = 0,
                             Clock::duration interval = std::chrono::milliseconds(20));

  /// Reports where the run is, at once. Returns whether the run is cancelled.
  bool report_progress(const emtr_progress& progress);

  /// Reports this stage in place of all that are reported from now on, until null is given: a whole
  /// registration can be one stage of another.
  void hold_stage(const char* name) { held_stage_ = name; }

  bool cancelled() const { return cancelled_.load(std::memory_order_relaxed); }
  /// Tells whether the time limit, and not the caller, cancelled the run.
  bool timed_out() const { return timed_out_; }

 private:
  friend void check_cancelled();

  void ask_when_due();  ///< asks the caller when the interval is over; throws Cancelled
  bool ask_caller(Clock::time_point now);

  const OnProgress on_progress_;
  const double time_limit_;
  const Clock::duration interval_;
  const Clock::time_point start_ = Clock::now();
  Clock::time_point last_asked_ = start_;
  emtr_progress progress_ = {stage_name(Stage::Normalization), 0, 0, 0, 0};
  const char* held_stage_ = nullptr;
  std::atomic<bool> cancelled_{false};
  bool timed_out_ = false;
};

/// Makes a token current on this thread, so that the inner loops need not pass it down through
/// every call, and a run inside the callback of another has its own.
class CancellationScope {
 public:
  /// Lets check_cancelled() on this thread use `token` until the scope ends; none for null. Only
  /// the owner's thread asks the caller.
  explicit CancellationScope(CancellationToken* token, bool owner = true);
  ~CancellationScope();
  CancellationScope(const CancellationScope&) = delete;
  CancellationScope& operator=(const CancellationScope&) = delete;

  static CancellationToken* current();

 private:
  CancellationToken* const previous_;
  const bool previous_owner_;
};

/// Throws Cancelled when the run is cancelled; asks the caller first on the run's own thread. Every
/// small piece of work calls it.
void check_cancelled();

/// Calls check_cancelled() in a loop of small steps, at every 2^shift-th.
inline void check_cancelled_each(std::size_t step, int shift) {
  if ((step & ((std::size_t{1} << shift) - 1)) == 0) check_cancelled();
}

}  // namespace emtr
