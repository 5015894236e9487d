#include "util/cancellation.h"

#include <utility>

namespace emtr {
namespace {

struct Current {
  CancellationToken* watch = nullptr;
  bool owner = false;  // whether this is the thread that the watch was made on
};
thread_local Current at_work;

}  // namespace

CancellationToken::CancellationToken(OnProgress on_progress, double seconds, Clock::duration every)
    : on_progress_(std::move(on_progress)), limit_(seconds), every_(every) {}

bool CancellationToken::tell(const emtr_progress& progress) {
  progress_ = progress;
  return stopped() || ask(Clock::now());
}

void CancellationToken::look() {
  const Clock::time_point now = Clock::now();
  if (now - asked_ >= every_ && ask(now)) throw Cancelled();
}

bool CancellationToken::ask(Clock::time_point now) {
  bool stop = false;
  if (on_progress_) {
    const CancellationScope nobody(nullptr);  // the caller may come back into the library
    try {
      stop = on_progress_(progress_);
    } catch (...) {
      stopped_.store(true, std::memory_order_relaxed);  // the helpers too let go of their work
      throw;
    }
  }
  asked_ = Clock::now();  // what the caller did with the time is its own
  if (!stop && limit_ > 0 && std::chrono::duration<double>(now - start_).count() >= limit_)
    stop = late_ = true;
  if (stop) stopped_.store(true, std::memory_order_relaxed);
  return stop;
}

CancellationScope::CancellationScope(CancellationToken* watch, bool owner) : before_(at_work.watch), owned_before_(at_work.owner) {
  at_work = {watch, owner};
}

CancellationScope::~CancellationScope() { at_work = {before_, owned_before_}; }

CancellationToken* CancellationScope::current() { return at_work.watch; }

void check_cancelled() {
  if (!at_work.watch) return;
  if (at_work.watch->stopped()) throw Cancelled();
  if (at_work.owner) at_work.watch->look();
}

}  // namespace emtr
