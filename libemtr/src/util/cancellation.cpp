#include "util/cancellation.h"

#include <utility>

namespace emtr {
namespace {

struct Current {
  CancellationToken* token = nullptr;
  bool owner = false;  // whether the token was made on this thread
};
thread_local Current current_on_thread;

}  // namespace

CancellationToken::CancellationToken(OnProgress on_progress, double seconds,
                                     Clock::duration interval)
    : on_progress_(std::move(on_progress)), time_limit_(seconds), interval_(interval) {}

bool CancellationToken::report_progress(const emtr_progress& progress) {
  progress_ = held_stage_ ? emtr_progress{held_stage_, 0, 0, 0, 0} : progress;
  return cancelled() || ask_caller(Clock::now());
}

void CancellationToken::ask_when_due() {
  const Clock::time_point now = Clock::now();
  if (now - last_asked_ >= interval_ && ask_caller(now)) throw Cancelled();
}

bool CancellationToken::ask_caller(Clock::time_point now) {
  bool stop = false;
  if (on_progress_) {
    const CancellationScope none(nullptr);  // the callback may call the library again
    try {
      stop = on_progress_(progress_);
    } catch (...) {
      cancelled_.store(true, std::memory_order_relaxed);  // the helpers too end their work
      throw;
    }
  }
  last_asked_ = Clock::now();  // leaves the time that the callback took out of the interval
  if (!stop && time_limit_ > 0 &&
      std::chrono::duration<double>(now - start_).count() >= time_limit_)
    stop = timed_out_ = true;
  if (stop) cancelled_.store(true, std::memory_order_relaxed);
  return stop;
}

CancellationScope::CancellationScope(CancellationToken* token, bool owner)
    : previous_(current_on_thread.token), previous_owner_(current_on_thread.owner) {
  current_on_thread = {token, owner};
}

CancellationScope::~CancellationScope() { current_on_thread = {previous_, previous_owner_}; }

CancellationToken* CancellationScope::current() { return current_on_thread.token; }

void check_cancelled() {
  const Current& current = current_on_thread;
  if (!current.token) return;
  if (current.token->cancelled()) throw Cancelled();
  if (current.owner) current.token->ask_when_due();
}

}  // namespace emtr
