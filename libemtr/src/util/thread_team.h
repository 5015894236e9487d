#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>

#include "util/cancellation.h"

namespace emtr {

/// The threads of one OpenMP parallel region. Between two pieces of work they soon sleep, as
/// threads that spin on are slower than one alone on a machine with other work to do; between two
/// regions it is OpenMP that has them spin. So a registration opens one for all of its stages.
class ThreadTeam {
 public:
  /// Runs body(team) on the calling thread, in a parallel region with up to `threads` threads.
  /// Throws what the body throws. Inside the body of another team of the same run, outside of its
  /// jobs, the body gets that team.
  static void with(int threads, const std::function<void(ThreadTeam&)>& body);

  /// At most this many threads; their numbers in a job are below it.
  std::size_t size() const { return threads_; }

  /// Runs job(i, thread) once for each i < n, in any order, and returns when all are done. Throws
  /// what the first failing job threw. Polls after each job, so these are to be small or to poll
  /// themselves.
  using Job = std::function<void(std::size_t i, std::size_t thread)>;
  void parallel(std::size_t n, const Job& job);

 private:
  explicit ThreadTeam(std::size_t threads) : threads_(threads) {}
  bool begin();  ///< takes the memory that a new thread needs, if there is any
  void wait_for_beginners(std::size_t helpers);  ///< until so many threads have
  bool serves(int threads) const;   ///< whether a body that asks for so many can have this team
  void follow(std::size_t thread);  ///< what the helpers do until they are dismissed
  void work(std::size_t thread);
  void wait_for_helpers();
  void fail();  ///< keeps the exception at hand for the caller of parallel()
  void dismiss();

  const std::size_t threads_;
  CancellationToken* const token_ = CancellationScope::current();
  std::mutex mutex_;
  std::condition_variable wake_, idle_;
  const Job* job_ = nullptr;
  std::size_t begun_ = 0;  // new threads that have taken their memory
  std::size_t size_ = 0;   // of the present piece of work
  std::atomic<std::size_t> next_{0};
  std::atomic<std::size_t> busy_{0};   // helpers at it
  std::atomic<std::size_t> round_{0};  // pieces of work given out so far
  bool open_ = false;                  // helpers that wake too late for a piece leave it alone
  std::atomic<bool> dismissed_{false};
  std::exception_ptr failure_;
};

/// Runs job(i) once for each i < n on a team of its own, and throws what the first failing job
/// threw. Jobs that keep their results by i make a whole that does not depend on the threads. The
/// team has all threads even for a few jobs: OpenMP ends those of its pool that a region leaves
/// out.
template <class Job>
void parallel_for(std::size_t n, int threads, const Job& job) {
  ThreadTeam::with(n > 1 ? threads : 1, [&](ThreadTeam& team) {
    team.parallel(n, [&](std::size_t i, std::size_t) { job(i); });
  });
}

}  // namespace emtr
