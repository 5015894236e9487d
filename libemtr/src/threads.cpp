#include "threads.h"

#include <omp.h>

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace emtr {
namespace {

/// Threads that do nothing but be there, all at one time.
class Trial {
 public:
  Trial() = default;
  Trial(const Trial&) = delete;
  Trial& operator=(const Trial&) = delete;
  ~Trial() {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      over_ = true;
    }
    wake_.notify_all();
    for (std::thread& thread : threads_) thread.join();
  }

  /// How many of `wanted` there could be.
  int start(int wanted) {
    threads_.reserve(static_cast<std::size_t>(wanted));
    try {
      while (static_cast<int>(threads_.size()) < wanted) threads_.emplace_back([this] { wait(); });
    } catch (const std::system_error&) {  // no more threads: their number is the answer
    }
    return static_cast<int>(threads_.size());
  }

 private:
  void wait() {
    std::unique_lock<std::mutex> lock(mutex_);
    wake_.wait(lock, [this] { return over_; });
  }

  std::mutex mutex_;
  std::condition_variable wake_;
  bool over_ = false;
  std::vector<std::thread> threads_;
};

thread_local int last = 1;  // threads of this thread's last region, which OpenMP has kept

}  // namespace

int available_threads(int threads) {
  if (omp_get_active_level() >= omp_get_max_active_levels()) return 1;  // it would give no more
  // Within a region, even one of a single thread, OpenMP makes its threads anew each time.
  const bool kept = omp_get_level() == 0;
  const int have = kept ? last : 1;
  // One more than are missing, so that a little memory is left over. The C library keeps the stacks
  // of the trial for the threads that come.
  if (threads > have)
    threads = std::min(threads, have + std::max(0, Trial().start(threads - have + 1) - 1));
  if (kept) last = threads;
  return threads;
}

}  // namespace emtr
