#pragma once

#include <cstdint>

#if defined(__aarch64__)

/// The control register of this thread's arithmetic, without the flags of exceptions.
inline std::uint64_t arithmetic_control() {
  std::uint64_t fpcr;
  __asm__ volatile("mrs %0, fpcr" : "=r"(fpcr));
  return fpcr;
}
inline void set_arithmetic_control(std::uint64_t fpcr) {
  __asm__ volatile("msr fpcr, %0" : : "r"(fpcr));
}
/// Takes denormals for zero, in operands and in results.
constexpr std::uint64_t kFlushDenormals = 1u << 24;  // FZ

#else
#include <xmmintrin.h>

inline std::uint64_t arithmetic_control() { return _mm_getcsr() & ~_MM_EXCEPT_MASK; }
inline void set_arithmetic_control(std::uint64_t mxcsr) {
  _mm_setcsr(static_cast<unsigned>(mxcsr));
}
constexpr std::uint64_t kFlushDenormals = 0x8040;  // FTZ and DAZ

#endif
