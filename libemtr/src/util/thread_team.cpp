#include "util/thread_team.h"

#include <omp.h>

#include <chrono>
#include <utility>

#include "util/blocked_signals.h"
#include "util/default_arithmetic.h"
#include "util/openmp_pool.h"
#include "util/spin_wait.h"
#include "util/thread_probe.h"

namespace emtr {
namespace {

thread_local ThreadTeam* leading = nullptr;  // the team whose body this thread runs

}  // namespace

void ThreadTeam::with(int threads, const std::function<void(ThreadTeam&)>& body) {
  if (leading && leading->serves(threads)) return body(*leading);
  RegionOpening opening(threads);
  ThreadTeam team(static_cast<std::size_t>(opening.threads()));
  if (team.size() == 1) return body(team);
  const bool new_threads = opening.makes_threads();
  std::exception_ptr failure;
#pragma omp parallel num_threads(opening.threads())
  {
    const auto thread = static_cast<std::size_t>(omp_get_thread_num());
    const bool ready = thread == 0 || !new_threads || team.begin();
    if (thread == 0) {
      if (new_threads) team.wait_for_beginners(static_cast<std::size_t>(omp_get_num_threads() - 1));
      opening.begun();
      ThreadTeam* const before = std::exchange(leading, &team);
      try {
        body(team);
      } catch (...) {  // thrown on below: no exception may leave a region
        failure = std::current_exception();
      }
      leading = before;
      team.dismiss();
    } else if (ready) {
      team.follow(thread);
    }
  }
  if (failure) std::rethrow_exception(failure);
}

bool ThreadTeam::serves(int threads) const {
  return threads > 1 && size() <= static_cast<std::size_t>(threads) && !job_ &&
         token_ == CancellationScope::current();
}

/// One thread after the other, while nobody else takes memory: a thread whose first allocation
/// fails, that of its thread-local data, ends the process.
bool ThreadTeam::begin() {
  const std::lock_guard<std::mutex> lock(mutex_);
  ++begun_;
  idle_.notify_one();
  if (!room_to_begin()) return false;
  check_cancelled();  // looks at our thread-local data, and this at that of the exceptions
  [[maybe_unused]] const volatile int none = std::uncaught_exceptions();  // else left out: pure
  return true;
}

/// Sleeps, where a barrier of OpenMP's would spin for milliseconds, on the processor that a new
/// thread may need.
void ThreadTeam::wait_for_beginners(std::size_t helpers) {
  std::unique_lock<std::mutex> lock(mutex_);
  idle_.wait(lock, [&] { return begun_ == helpers; });
}

void ThreadTeam::parallel(std::size_t n, const Job& job) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    job_ = &job;
    size_ = n;
    next_ = 0;
    failure_ = nullptr;
    open_ = true;
    ++round_;
  }
  wake_.notify_all();
  work(0);
  wait_for_helpers();
  job_ = nullptr;
  if (failure_) std::rethrow_exception(failure_);
  if (token_ && token_->cancelled()) throw Cancelled();
}

/// Meanwhile the run's own thread goes on asking its caller.
void ThreadTeam::wait_for_helpers() {
  const auto done = [this] { return busy_ == 0; };
  spin_wait(done);
  std::unique_lock<std::mutex> lock(mutex_);
  open_ = false;
  while (token_ && !failure_ && !idle_.wait_for(lock, std::chrono::milliseconds(10), done)) {
    lock.unlock();
    try {
      check_cancelled();
    } catch (...) {  // thrown on by parallel(), when the helpers have let go of the job
      fail();
    }
    lock.lock();
  }
  idle_.wait(lock, done);
}

void ThreadTeam::follow(std::size_t thread) {
  // The pool's threads are as whoever opened the first region made them. At work they take no
  // signals: handlers run on threads of the caller's.
  const BlockedSignals blocked;
  const DefaultArithmetic arithmetic;
  const bool owner = false;
  const CancellationScope scope(token_, owner);
  std::unique_lock<std::mutex> lock(mutex_);
  for (std::size_t seen = 0;;) {
    lock.unlock();
    spin_wait([&] { return dismissed_ || round_ != seen; });
    lock.lock();
    wake_.wait(lock, [&] { return dismissed_ || (open_ && round_ != seen); });
    if (dismissed_) return;
    seen = round_;
    ++busy_;
    lock.unlock();
    work(thread);
    lock.lock();
    if (--busy_ == 0) idle_.notify_one();
  }
}

void ThreadTeam::work(std::size_t thread) {
  try {
    for (std::size_t i; (i = next_++) < size_;) {
      (*job_)(i, thread);
      check_cancelled();
    }
  } catch (const Cancelled&) {  // not in the place of what the caller threw when it was asked
    next_ = size_;
  } catch (...) {  // thrown on by parallel()
    fail();
  }
}

void ThreadTeam::fail() {
  next_ = size_;
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!failure_) failure_ = std::current_exception();
}

void ThreadTeam::dismiss() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    dismissed_ = true;
  }
  wake_.notify_all();
}

}  // namespace emtr
