#pragma once

#include <emtr/emtr.h>

#include <atomic>
#include <chrono>
#include <functional>

#include "util/stage.h"

namespace emtr {

/// Tells the caller how far things are; true stops the run.
using OnProgress = std::function<bool(const emtr_progress&)>;

/// Thrown out of the midst of the work when the run is to end. Whoever holds the best pose so far
/// catches it.
struct Cancelled {};

/// The eye on one run: tells its caller how far it is, and ends it when the caller or the time
/// limit says so. All work calls check_cancelled() every few milliseconds at most, on whichever thread; how
/// often the caller is really asked depends on the clock, so results never depend on polls.
class CancellationToken {
 public:
  using Clock = std::chrono::steady_clock;

  /// `seconds` from now on, 0 for no limit; `every`: how often the caller is asked, so that a stop
  /// takes this long and one piece of work. Its methods are for the thread that made it.
  explicit CancellationToken(OnProgress on_progress, double seconds = 0,
                 Clock::duration every = std::chrono::milliseconds(20));

  /// Where the run is; asks the caller at once. True: the run is to end.
  bool tell(const emtr_progress& progress);

  bool stopped() const { return stopped_.load(std::memory_order_relaxed); }
  /// Whether it was stopped by the time limit and not by the caller.
  bool late() const { return late_; }

 private:
  friend void check_cancelled();

  void look();  ///< asks again when the last time is a while ago
  bool ask(Clock::time_point now);

  const OnProgress on_progress_;
  const double limit_;
  const Clock::duration every_;
  const Clock::time_point start_ = Clock::now();
  Clock::time_point asked_ = start_;
  emtr_progress progress_ = {stage_name(Stage::Normalization), 0, 0, 0, 0};
  std::atomic<bool> stopped_{false};
  bool late_ = false;
};

/// Whose work this thread does at present. Kept by thread, so that the inner loops need not hand it
/// down through every call, and a run inside a callback of another has its own.
class CancellationScope {
 public:
  /// Until it goes out of scope, check_cancelled() on this thread asks `watch`; null: nobody.
  explicit CancellationScope(CancellationToken* watch, bool owner = true);
  ~CancellationScope();
  CancellationScope(const CancellationScope&) = delete;
  CancellationScope& operator=(const CancellationScope&) = delete;

  static CancellationToken* current();

 private:
  CancellationToken* const before_;
  const bool owned_before_;
};

/// To be called after each small piece of work. Throws Stopped when the run is to end; on the run's
/// own thread it asks the caller first.
void check_cancelled();

/// check_cancelled() in a loop of small steps: at every 2^shift-th.
inline void check_cancelled_each(std::size_t step, int shift) {
  if ((step & ((std::size_t{1} << shift) - 1)) == 0) check_cancelled();
}

}  // namespace emtr
