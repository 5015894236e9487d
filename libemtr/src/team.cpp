#include "team.h"

#include <signal.h>

#include <chrono>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

namespace emtr {
namespace {

/// While it lives, no signal is delivered to this thread or to those that it starts: handlers run
/// on threads of the caller's, as if ours were not there.
class SignalsHeld {
 public:
  SignalsHeld() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before_);
  }
  ~SignalsHeld() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  SignalsHeld(const SignalsHeld&) = delete;
  SignalsHeld& operator=(const SignalsHeld&) = delete;

 private:
  sigset_t before_;
};

}  // namespace

class Team::Helpers {
 public:
  explicit Helpers(Team& team) : team_(team) {
    if (team.size() <= 1) return;
    const SignalsHeld held;
    threads_.reserve(team.size() - 1);
    try {
      for (std::size_t thread = 1; thread < team.size(); ++thread)
        threads_.emplace_back([&team, thread] { team.follow(thread); });
    } catch (const std::system_error&) {
      // The system has no more threads to give: those that there are do all of the work, to the
      // same result.
    } catch (const std::bad_alloc&) {  // the same; and those that run must be joined
    }
  }
  ~Helpers() {
    team_.dismiss();
    for (std::thread& thread : threads_) thread.join();
  }
  Helpers(const Helpers&) = delete;
  Helpers& operator=(const Helpers&) = delete;

 private:
  Team& team_;
  std::vector<std::thread> threads_;
};

void Team::with(int threads, const std::function<void(Team&)>& body) {
  Team team(static_cast<std::size_t>(threads));
  const Helpers helpers(team);
  body(team);
}

void Team::parallel(std::size_t n, const Job& job) {
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
  if (failure_) std::rethrow_exception(failure_);
}

/// Meanwhile the run's own thread goes on asking its caller.
void Team::wait_for_helpers() {
  std::unique_lock<std::mutex> lock(mutex_);
  open_ = false;
  const auto done = [this] { return busy_ == 0; };
  while (watch_ && !failure_ && !idle_.wait_for(lock, std::chrono::milliseconds(10), done)) {
    lock.unlock();
    try {
      poll();
    } catch (...) {  // thrown on by parallel(), when the helpers have let go of the job
      fail();
    }
    lock.lock();
  }
  idle_.wait(lock, done);
}

void Team::follow(std::size_t thread) {
  const bool owner = false;
  const Watched watched(watch_, owner);
  std::unique_lock<std::mutex> lock(mutex_);
  for (std::size_t seen = 0;;) {
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

void Team::work(std::size_t thread) {
  try {
    for (std::size_t i; (i = next_++) < size_;) {
      (*job_)(i, thread);
      poll();
    }
  } catch (...) {  // thrown on by parallel()
    fail();
  }
}

void Team::fail() {
  next_ = size_;
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!failure_) failure_ = std::current_exception();
}

void Team::dismiss() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    dismissed_ = true;
  }
  wake_.notify_all();
}

}  // namespace emtr
