#include "team.h"

#include <omp.h>

#include "threads.h"

namespace emtr {

void Team::with(int threads, const std::function<void(Team&)>& body) {
  threads = available_threads(threads);
  Team team;
  team.threads_ = static_cast<std::size_t>(threads);
  if (threads == 1) return body(team);
  std::exception_ptr failure;
#pragma omp parallel num_threads(threads)
  {
    const auto thread = static_cast<std::size_t>(omp_get_thread_num());
    if (thread == 0) {
      try {
        body(team);
      } catch (...) {  // an exception must not leave the region; it is thrown on below
        failure = std::current_exception();
      }
      team.dismiss();
    } else {
      team.follow(thread);
    }
  }
  if (failure) std::rethrow_exception(failure);
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
  std::unique_lock<std::mutex> lock(mutex_);
  open_ = false;
  idle_.wait(lock, [this] { return busy_ == 0; });
  if (failure_) std::rethrow_exception(failure_);
}

void Team::follow(std::size_t thread) {
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
    for (std::size_t i; (i = next_++) < size_;) (*job_)(i, thread);
  } catch (...) {  // kept for the caller of parallel()
    next_ = size_;
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!failure_) failure_ = std::current_exception();
  }
}

void Team::dismiss() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    dismissed_ = true;
  }
  wake_.notify_all();
}

}  // namespace emtr
