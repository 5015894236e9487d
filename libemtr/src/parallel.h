#pragma once

#include <cstddef>
#include <exception>
#include <mutex>

#include "threads.h"

namespace emtr {

/// Runs job(i) once for each i < n, on up to `threads` threads, and throws on what a job threw.
/// Jobs that keep their results by i make a whole that does not depend on the threads.
template <class Job>
void in_parallel(std::size_t n, int threads, const Job& job) {
  if (threads > 1 && n > 1) threads = available_threads(threads);
  if (threads == 1 || n < 2) {
    for (std::size_t i = 0; i < n; ++i) job(i);
    return;
  }
  std::exception_ptr failure;
  std::mutex mutex;  // a critical section would be a symbol that the library shows
#pragma omp parallel for schedule(dynamic) num_threads(threads)
  for (std::size_t i = 0; i < n; ++i) {
    try {
      job(i);
    } catch (...) {  // must not leave the region
      const std::lock_guard<std::mutex> lock(mutex);
      failure = std::current_exception();
    }
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace emtr
