#include "util/thread_probe.h"

#include <pthread.h>
#include <sys/mman.h>

#include <condition_variable>
#include <cstddef>
#include <cstdlib>
#include <mutex>
#include <vector>

#include "util/blocked_signals.h"

namespace emtr {
namespace {

/// Returns the stack size that OpenMP's threads are told to have, in bytes, or 0 for the default:
/// a number with a unit B, K, M or G, K if there is none.
std::size_t openmp_stack_size() {
  for (const char* name : {"OMP_STACKSIZE", "GOMP_STACKSIZE", "KMP_STACKSIZE"}) {
    const char* text = std::getenv(name);
    if (!text) continue;
    char* unit = nullptr;
    const std::size_t size = std::strtoul(text, &unit, 10);
    while (*unit == ' ') ++unit;
    switch (*unit) {
      case 'b':
      case 'B':
        return size;
      case 'm':
      case 'M':
        return size << 20;
      case 'g':
      case 'G':
        return size << 30;
      default:
        return size << 10;
    }
  }
  return 0;
}

/// Threads that wait until all of them are there, each with room for its first allocations.
class Probe {
 public:
  Probe() {
    pthread_attr_init(&attributes_);
    // A size that the C library does not accept is not taken by OpenMP's runtime either.
    if (const std::size_t size = openmp_stack_size()) pthread_attr_setstacksize(&attributes_, size);
  }
  ~Probe() { pthread_attr_destroy(&attributes_); }
  Probe(const Probe&) = delete;
  Probe& operator=(const Probe&) = delete;

  /// Returns how many of `wanted` threads came.
  int count(int wanted) {
    const BlockedSignals blocked;  // no handler of the caller's is to run on them
    std::vector<pthread_t> threads;
    threads.reserve(static_cast<std::size_t>(wanted));
    open_ = false;
    begun_ = failed_ = 0;
    std::unique_lock<std::mutex> lock(mutex_);
    for (pthread_t thread; static_cast<int>(threads.size()) < wanted;) {
      if (pthread_create(&thread, &attributes_, begin, this) != 0) break;
      threads.push_back(thread);
    }
    const int made = static_cast<int>(threads.size());
    changed_.wait(lock, [&] { return begun_ + failed_ == made; });
    const int came = begun_;
    open_ = true;
    lock.unlock();
    changed_.notify_all();
    for (const pthread_t thread : threads) pthread_join(thread, nullptr);
    return came;
  }

 private:
  static void* begin(void* probe) {
    static_cast<Probe*>(probe)->wait();
    return nullptr;
  }

  void wait() {
    std::unique_lock<std::mutex> lock(mutex_);
    ++(room_to_begin() ? begun_ : failed_);
    changed_.notify_all();
    changed_.wait(lock, [this] { return open_; });
  }

  pthread_attr_t attributes_;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool open_ = false;
  int begun_ = 0, failed_ = 0;
};

}  // namespace

bool room_to_begin() {
  constexpr std::size_t enough = std::size_t{1} << 20;
  void* room = mmap(nullptr, enough, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  return room != MAP_FAILED && munmap(room, enough) == 0;
}

int probe_threads(int wanted) {
  Probe probe;
  while (wanted > 0) {
    const int came = probe.count(wanted);
    if (came == wanted) break;
    wanted = came / 2;
  }
  return wanted > 0 ? wanted : 0;
}

}  // namespace emtr
