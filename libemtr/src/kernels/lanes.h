#pragma once

#include "kernels.h"

// Eight numbers side by side, in as many registers as the instruction set needs for them. Only for
// the files of this folder: each instruction set has a namespace of its own.

#if defined(__AVX2__)
#define EMTR_REGISTER 8  // floats
#else
#define EMTR_REGISTER 4
#endif
#define EMTR_INLINE static inline __attribute__((always_inline))

namespace emtr::EMTR_KERNEL {

constexpr std::size_t kRegisters = kLanes / EMTR_REGISTER;

struct Floats {
  typedef float Register __attribute__((vector_size(4 * EMTR_REGISTER)));
  Register r[kRegisters];
};

struct Ints {
  typedef std::int32_t Register __attribute__((vector_size(4 * EMTR_REGISTER)));
  Register r[kRegisters];
};

/// Result of an operation, register by register.
#define EMTR_EACH(Type, expression)                                   \
  Type out;                                                           \
  for (std::size_t i = 0; i < kRegisters; ++i) out.r[i] = expression; \
  return out

EMTR_INLINE Floats operator+(const Floats& a, const Floats& b) {
  EMTR_EACH(Floats, a.r[i] + b.r[i]);
}
EMTR_INLINE Floats operator-(const Floats& a, const Floats& b) {
  EMTR_EACH(Floats, a.r[i] - b.r[i]);
}
EMTR_INLINE Floats operator*(const Floats& a, const Floats& b) {
  EMTR_EACH(Floats, a.r[i] * b.r[i]);
}
EMTR_INLINE Floats operator*(float a, const Floats& b) { EMTR_EACH(Floats, a * b.r[i]); }
EMTR_INLINE Ints operator<(const Floats& a, const Floats& b) { EMTR_EACH(Ints, a.r[i] < b.r[i]); }
EMTR_INLINE Ints operator>=(const Floats& a, const Floats& b) { EMTR_EACH(Ints, a.r[i] >= b.r[i]); }
EMTR_INLINE Ints operator+(const Ints& a, const Ints& b) { EMTR_EACH(Ints, a.r[i] + b.r[i]); }
EMTR_INLINE Ints operator-(const Ints& a, const Ints& b) { EMTR_EACH(Ints, a.r[i] - b.r[i]); }
EMTR_INLINE Ints operator*(const Ints& a, std::int32_t b) { EMTR_EACH(Ints, a.r[i] * b); }
EMTR_INLINE Ints operator&(const Ints& a, const Ints& b) { EMTR_EACH(Ints, a.r[i] & b.r[i]); }
EMTR_INLINE Ints operator|(const Ints& a, const Ints& b) { EMTR_EACH(Ints, a.r[i] | b.r[i]); }
EMTR_INLINE Ints operator~(const Ints& a) { EMTR_EACH(Ints, ~a.r[i]); }

EMTR_INLINE Floats least(const Floats& a, const Floats& b) {
  EMTR_EACH(Floats, b.r[i] < a.r[i] ? b.r[i] : a.r[i]);
}

/// Towards zero.
EMTR_INLINE Ints truncated(const Floats& a) {
  EMTR_EACH(Ints, __builtin_convertvector(a.r[i], Ints::Register));
}

/// `a` where all bits of `mask` are set, 0 where none is.
EMTR_INLINE Floats masked(const Floats& a, const Ints& mask) {
  EMTR_EACH(Floats, (Floats::Register)((Ints::Register)a.r[i] & mask.r[i]));
}

EMTR_INLINE Floats all(float value) { EMTR_EACH(Floats, value - Floats::Register{}); }

template <class Type, class Number>
EMTR_INLINE Type loaded(const Number* from) {
  Type out;
  __builtin_memcpy(&out, from, sizeof out);
  return out;
}

template <class Type, class Number>
EMTR_INLINE void store(Number* to, const Type& from) {
  __builtin_memcpy(to, &from, sizeof from);
}

/// The least of the eight.
EMTR_INLINE float least_of(const Floats& a) {
#if EMTR_REGISTER == 8
  Floats::Register v = a.r[0], w = __builtin_shufflevector(v, v, 4, 5, 6, 7, 0, 1, 2, 3);
  v = w < v ? w : v;
  w = __builtin_shufflevector(v, v, 2, 3, 0, 1, 6, 7, 4, 5);
  v = w < v ? w : v;
  w = __builtin_shufflevector(v, v, 1, 0, 3, 2, 5, 4, 7, 6);
#else
  Floats::Register v = a.r[1] < a.r[0] ? a.r[1] : a.r[0];
  Floats::Register w = __builtin_shufflevector(v, v, 2, 3, 0, 1);
  v = w < v ? w : v;
  w = __builtin_shufflevector(v, v, 1, 0, 3, 2);
#endif
  v = w < v ? w : v;
  return v[0];
}

#undef EMTR_EACH

}  // namespace emtr::EMTR_KERNEL
