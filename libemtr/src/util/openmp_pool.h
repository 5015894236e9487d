#pragma once

#include <mutex>

namespace emtr {

/// Secures what a parallel region needs before it opens. OpenMP keeps the threads of a region in a
/// pool, of the calling thread's own in GCC's runtime, until the next region takes them. The pool
/// is given up before a fork, as its threads are not in the child, which would wait for them.
class RegionOpening {
 public:
  /// Finds out how many threads, at most `wanted`, the region may ask for: those of the pool, and
  /// new ones if the system gives them. While new ones are made, no other thread of the process
  /// may make some. Throws std::bad_alloc where OpenMP's runtime would end the process for want of
  /// memory.
  explicit RegionOpening(int wanted);

  int threads() const { return threads_; }
  /// Whether the region makes new threads, which are to take their memory before begun().
  bool makes_threads() const { return growing_.owns_lock(); }
  /// To be called once in the region, by the thread that opened it, when all threads are there.
  void begun();

 private:
  int threads_ = 1;
  std::unique_lock<std::mutex> growing_;
};

}  // namespace emtr
