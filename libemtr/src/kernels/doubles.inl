// Defines doubles side by side. Included by the loops that need them.

#pragma once

#include "kernels/lanes.h"

namespace emtr::EMTR_KERNEL {
namespace {

constexpr std::size_t kDoubles = EMTR_REGISTER >= 8 ? 4 : 2;
typedef double Doubles __attribute__((vector_size(8 * kDoubles)));
typedef std::int64_t DoublesMask __attribute__((vector_size(8 * kDoubles)));
typedef float Halves __attribute__((vector_size(4 * kDoubles)));

EMTR_INLINE Doubles load_doubles(const float* from) {
  Halves half;
  __builtin_memcpy(&half, from, sizeof half);
  return __builtin_convertvector(half, Doubles);
}

}  // namespace
}  // namespace emtr::EMTR_KERNEL
