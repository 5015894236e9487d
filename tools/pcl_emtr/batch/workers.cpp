#include "batch/workers.h"

#include <sched.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>

#include "batch/cloud_cache.h"
#include "batch/register_pair.h"
#include "interrupt.h"

namespace cli {
namespace {

/// Returns how many processors this process may use.
std::size_t processors() {
  cpu_set_t set;
  if (sched_getaffinity(0, sizeof set, &set) == 0) return static_cast<std::size_t>(CPU_COUNT(&set));
  return std::max(1U, std::thread::hardware_concurrency());
}

}  // namespace

void work_on(const std::vector<const Pair*>& pairs, const Options& options, RecordFile& records,
             StatusLine& status) {
  CloudCache cache(options.batch.cache_bytes);
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::exception_ptr failure;  // of writing: the pairs' own faults are records
  const auto work = [&] {
    try {
      for (;;) {
        const std::size_t at = next++;
        if (at >= pairs.size() || Interrupt::requested()) return;
        const auto record = register_pair(*pairs[at], options, cache, status);
        if (!record) return;
        records.append(*record);
        status.show(records.counts());
      }
    } catch (...) {
      next = pairs.size();
      const std::lock_guard<std::mutex> lock(mutex);
      if (!failure) failure = std::current_exception();
    }
  };
  const std::size_t wanted = options.batch.workers ? options.batch.workers : processors();
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < std::min(wanted, pairs.size()); ++i) threads.emplace_back(work);
  for (auto& thread : threads) thread.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace cli
