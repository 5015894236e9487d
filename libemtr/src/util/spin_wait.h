#pragma once

namespace emtr {

/// Asks `done()` again and again for some ten microseconds, about as long as it takes to wake a
/// thread that sleeps. Returns whether it was true. Longer would take time from whoever else is at
/// work on the machine.
template <class Done>
bool spin_wait(const Done& done) {
  constexpr int kRounds = 400;
  for (int i = 0; i < kRounds; ++i) {
    if (done()) return true;
#if defined(__x86_64__) || defined(__i386__)
    __builtin_ia32_pause();
#elif defined(__aarch64__)
    asm volatile("yield");
#endif
  }
  return done();
}

}  // namespace emtr
