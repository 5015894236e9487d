#include "util/openmp_pool.h"

#include <dlfcn.h>
#include <omp.h>
#include <pthread.h>

#include <cstddef>
#include <new>

#include "util/thread_probe.h"

namespace emtr {
namespace {

std::mutex growing;           // held while threads are probed and made
thread_local int pooled = 1;  // threads of the last region opened by this thread, itself included

/// Whether LLVM's OpenMP runtime is the one in use. It begins anew in a forked child by itself, and
/// crashes if one thread pauses it while others are in regions of theirs.
bool is_llvm_runtime() {
  Dl_info in_use, llvm;
  void* const of_llvm = dlsym(RTLD_DEFAULT, "kmp_get_blocktime");
  return of_llvm && dladdr(of_llvm, &llvm) != 0 &&
         dladdr(reinterpret_cast<void*>(&omp_pause_resource_all), &in_use) != 0 &&
         llvm.dli_fbase == in_use.dli_fbase;
}

/// Gives up the pool of the forking thread, the only thread that lives on in the child. Pools of
/// other threads are of no concern: the child has none of those threads. Inside of a region the
/// runtime cannot give it up.
void before_fork() {
  growing.lock();
  pooled = 1;
  if (omp_get_level() == 0 && !is_llvm_runtime()) omp_pause_resource_all(omp_pause_hard);
}

void after_fork() { growing.unlock(); }

/// The runtimes end the process if they get no memory for the records of a region.
void require_room_for_records(int threads) {
  const std::size_t enough = (std::size_t{64} << 10) + (static_cast<std::size_t>(threads) << 10);
  ::operator delete(::operator new(enough));
}

}  // namespace

RegionOpening::RegionOpening(int wanted) {
  // A region within as many as may be active has one thread, the calling one.
  if (wanted <= 1 || omp_get_active_level() >= omp_get_max_active_levels()) return;
  static std::once_flag registered;  // survives a fork meanwhile, unlike a static's own guard
  std::call_once(registered, [] {
    if (pthread_atfork(before_fork, after_fork, after_fork) != 0) throw std::bad_alloc();
  });

  const int have = omp_get_level() == 0 ? pooled : 1;  // pools are of outermost regions
  threads_ = wanted;
  if (wanted > have) {
    growing_ = std::unique_lock<std::mutex>(growing);
    threads_ = have + probe_threads(wanted - have);
    if (threads_ == have) growing_.unlock();
  }
  require_room_for_records(threads_);
}

void RegionOpening::begun() {
  if (omp_get_level() == 1) pooled = omp_get_num_threads();
  if (growing_) growing_.unlock();
}

}  // namespace emtr
