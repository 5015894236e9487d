#include "util/thread_team.h"

#include <signal.h>
#include <sys/mman.h>

#include <chrono>
#include <exception>
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

/// Whether a thread can have its first allocations: where it gets no heap of its own, each is some
/// pages. Asked of the system, as the C library may have room left in a heap that it does not
/// share.
bool room_to_begin() {
  constexpr std::size_t enough = std::size_t{1} << 20;
  void* room = mmap(nullptr, enough, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  return room != MAP_FAILED && munmap(room, enough) == 0;
}

}  // namespace

class ThreadTeam::Helpers {
 public:
  explicit Helpers(ThreadTeam& team) : team_(team) {
    if (team.size() <= 1) return;
    const SignalsHeld held;
    threads_.reserve(team.size() - 1);
    // Where the system has no more threads to give, half of those that it has given do all of the
    // work, to the same result: the stacks of all would leave no memory for it.
    for (std::size_t wanted = team.size() - 1; wanted > 0 && !start(wanted);) {
      wanted = threads_.size() / 2;
      stop();
    }
  }
  ~Helpers() { stop(); }
  Helpers(const Helpers&) = delete;
  Helpers& operator=(const Helpers&) = delete;

 private:
  /// False when there are not so many, or nothing is left beside them. They begin when all are
  /// there, and nobody else takes memory meanwhile: a thread whose first allocation fails, that of
  /// its thread-local data, ends the process.
  bool start(std::size_t wanted) {
    std::unique_lock<std::mutex> gate(team_.mutex_);
    try {
      for (std::size_t thread = 1; thread <= wanted; ++thread)
        threads_.emplace_back([this, thread] { begin(thread); });
    } catch (const std::system_error&) {
      team_.dismissed_ = true;
    } catch (const std::bad_alloc&) {
      team_.dismissed_ = true;
    }
    team_.idle_.wait(gate, [&] { return team_.dismissed_ || team_.begun_ == wanted; });
    return !team_.dismissed_;
  }

  void begin(std::size_t thread) {
    {
      const std::lock_guard<std::mutex> gate(team_.mutex_);
      if (team_.dismissed_) return;
      if (!room_to_begin()) {
        team_.dismissed_ = true;
        team_.idle_.notify_one();
        return;
      }
      check_cancelled();  // looks at our thread-local data, and this at that of the exceptions
      [[maybe_unused]] const volatile int none = std::uncaught_exceptions();  // else left out: pure
      ++team_.begun_;
    }
    team_.idle_.notify_one();
    team_.follow(thread);
  }

  void stop() {
    team_.dismiss();
    for (std::thread& thread : threads_) thread.join();
    threads_.clear();
    team_.dismissed_ = false;
    team_.begun_ = 0;
  }

  ThreadTeam& team_;
  std::vector<std::thread> threads_;
};

void ThreadTeam::with(int threads, const std::function<void(ThreadTeam&)>& body) {
  ThreadTeam team(static_cast<std::size_t>(threads));
  const Helpers helpers(team);
  body(team);
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
  if (failure_) std::rethrow_exception(failure_);
}

/// Meanwhile the run's own thread goes on asking its caller.
void ThreadTeam::wait_for_helpers() {
  std::unique_lock<std::mutex> lock(mutex_);
  open_ = false;
  const auto done = [this] { return busy_ == 0; };
  while (watch_ && !failure_ && !idle_.wait_for(lock, std::chrono::milliseconds(10), done)) {
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
  const bool owner = false;
  const CancellationScope watched(watch_, owner);
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

void ThreadTeam::work(std::size_t thread) {
  try {
    for (std::size_t i; (i = next_++) < size_;) {
      (*job_)(i, thread);
      check_cancelled();
    }
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
