#pragma once

#include "kernels/kernels.h"

// Defines numbers side by side, in as many registers as the instruction set needs for them. Only
// files of this folder may include this one: each instruction set has a namespace of its own.

#if defined(__AVX512F__)
#define EMTR_REGISTER 16  // floats
#elif defined(__AVX2__)
#define EMTR_REGISTER 8
#else
#define EMTR_REGISTER 4
#endif
#define EMTR_INLINE static inline __attribute__((always_inline))

namespace emtr::EMTR_KERNEL {

template <std::size_t Width>
struct Register;

#define EMTR_DEFINE_REGISTER(width)                                     \
  template <>                                                           \
  struct Register<width> {                                              \
    typedef float Float __attribute__((vector_size(4 * (width))));      \
    typedef std::int32_t Int __attribute__((vector_size(4 * (width)))); \
  }
EMTR_DEFINE_REGISTER(4);
EMTR_DEFINE_REGISTER(8);
EMTR_DEFINE_REGISTER(16);
#undef EMTR_DEFINE_REGISTER

// N numbers: one register, or two halves. (As an array of registers they would live in memory.)
template <std::size_t N, bool One = (N <= EMTR_REGISTER)>
struct Floats {
  Floats<N / 2> low, high;
};
template <std::size_t N>
struct Floats<N, true> {
  typename Register<N>::Float v;
};

/// Integers, or masks of all bits or none.
template <std::size_t N, bool One = (N <= EMTR_REGISTER)>
struct Ints {
  Ints<N / 2> low, high;
};
template <std::size_t N>
struct Ints<N, true> {
  typename Register<N>::Int v;
};

constexpr std::size_t kWide = 16;  // lanes of those sums that search no candidates
using Eight = Floats<kLanes>;
using Sixteen = Floats<kWide>;

template <std::size_t N>
constexpr bool one_register() {
  return N <= EMTR_REGISTER;
}

// An operation on all lanes of two operands, given for one register of each.
#define EMTR_BINARY(Result, A, B, name, expression)          \
  template <std::size_t N>                                   \
  EMTR_INLINE Result<N> name(const A<N>& a, const B<N>& b) { \
    if constexpr (one_register<N>())                         \
      return {expression};                                   \
    else                                                     \
      return {name(a.low, b.low), name(a.high, b.high)};     \
  }
#define EMTR_UNARY(Result, A, name, expression) \
  template <std::size_t N>                      \
  EMTR_INLINE Result<N> name(const A<N>& a) {   \
    if constexpr (one_register<N>())            \
      return {expression};                      \
    else                                        \
      return {name(a.low), name(a.high)};       \
  }

EMTR_BINARY(Floats, Floats, Floats, operator+, a.v + b.v)
EMTR_BINARY(Floats, Floats, Floats, operator-, a.v - b.v)
EMTR_BINARY(Floats, Floats, Floats, operator*, a.v* b.v)
EMTR_BINARY(Floats, Floats, Floats, operator/, a.v / b.v)
EMTR_BINARY(Ints, Floats, Floats, operator<, a.v < b.v)
EMTR_BINARY(Ints, Floats, Floats, operator>=, a.v >= b.v)
EMTR_BINARY(Ints, Ints, Ints, operator+, a.v + b.v)
EMTR_BINARY(Ints, Ints, Ints, operator-, a.v - b.v)
EMTR_BINARY(Ints, Ints, Ints, operator*, a.v* b.v)
EMTR_BINARY(Ints, Ints, Ints, operator&, a.v& b.v)
EMTR_BINARY(Ints, Ints, Ints, operator|, a.v | b.v)
EMTR_UNARY(Ints, Ints, operator~, ~a.v)
EMTR_UNARY(Ints, Ints, byte_up, a.v << 8)
EMTR_UNARY(Floats, Floats, magnitude,
           (typename Register<N>::Float)((typename Register<N>::Int)a.v & 0x7fffffff))
// The sign bit alone, and `a` with its sign flipped where that bit of b is set.
EMTR_UNARY(Ints, Floats, sign_of, (typename Register<N>::Int)a.v&(-0x7fffffff - 1))
EMTR_BINARY(Floats, Floats, Ints, flip_signs,
            (typename Register<N>::Float)((typename Register<N>::Int)a.v ^ b.v))
EMTR_BINARY(Floats, Floats, Floats, minimum, b.v < a.v ? b.v : a.v)
EMTR_BINARY(Floats, Floats, Floats, maximum, a.v > b.v ? a.v : b.v)  // b where a is no number
// Rounds towards zero.
EMTR_UNARY(Ints, Floats, truncated, __builtin_convertvector(a.v, typename Register<N>::Int))
// Keeps `a` where the mask b is set, else 0.
EMTR_BINARY(Floats, Floats, Ints, masked,
            (typename Register<N>::Float)((typename Register<N>::Int)a.v& b.v))

#undef EMTR_BINARY
#undef EMTR_UNARY

/// Returns `a` where the mask is set, else `b`.
template <std::size_t N>
EMTR_INLINE Floats<N> blend(const Ints<N>& mask, const Floats<N>& a, const Floats<N>& b) {
  if constexpr (one_register<N>())
    return {mask.v ? a.v : b.v};
  else
    return {blend(mask.low, a.low, b.low), blend(mask.high, a.high, b.high)};
}

/// Puts a number into every lane.
template <std::size_t N>
EMTR_INLINE Floats<N> broadcast(float value) {
  if constexpr (one_register<N>())
    return {value - typename Register<N>::Float{}};
  else
    return {broadcast<N / 2>(value), broadcast<N / 2>(value)};
}
template <std::size_t N>
EMTR_INLINE Ints<N> broadcast(std::int32_t value) {
  if constexpr (one_register<N>())
    return {value - typename Register<N>::Int{}};
  else
    return {broadcast<N / 2>(value), broadcast<N / 2>(value)};
}

// Loads register by register: whole structs copied as bytes would stay in memory.
template <std::size_t N>
EMTR_INLINE Floats<N> load(const float* from) {
  if constexpr (one_register<N>()) {
    Floats<N> out;
    __builtin_memcpy(&out.v, from, sizeof out.v);
    return out;
  } else {
    return {load<N / 2>(from), load<N / 2>(from + N / 2)};
  }
}

template <std::size_t N>
EMTR_INLINE Ints<N> load_ints(const std::int32_t* from) {
  if constexpr (one_register<N>()) {
    Ints<N> out;
    __builtin_memcpy(&out.v, from, sizeof out.v);
    return out;
  } else {
    return {load_ints<N / 2>(from), load_ints<N / 2>(from + N / 2)};
  }
}

template <std::size_t N, template <std::size_t, bool> class Lanes, class Number>
EMTR_INLINE void store(Number* to, const Lanes<N, one_register<N>()>& from) {
  if constexpr (one_register<N>()) {
    __builtin_memcpy(to, &from.v, sizeof from.v);
  } else {
    store<N / 2, Lanes>(to, from.low);
    store<N / 2, Lanes>(to + N / 2, from.high);
  }
}

template <std::size_t N>
EMTR_INLINE Floats<N> root(const Floats<N>& a) {
  if constexpr (one_register<N>()) {
    float each[N];
    __builtin_memcpy(each, &a.v, sizeof each);
    for (float& value : each) value = __builtin_sqrtf(value);
    return load<N>(each);
  } else {
    return {root(a.low), root(a.high)};
  }
}

/// Tells whether the mask is set in any lane.
template <std::size_t N>
EMTR_INLINE bool any(const Ints<N>& mask) {
  if constexpr (one_register<N>()) {
#if defined(__AVX512DQ__)
    if constexpr (N == 16) return __builtin_ia32_cvtd2mask512(mask.v) != 0;
#endif
#if defined(__AVX2__)
    if constexpr (N == 8)
      return __builtin_ia32_movmskps256((typename Register<N>::Float)mask.v) != 0;
#endif
#if defined(__SSE2__)
    if constexpr (N == 4) return __builtin_ia32_movmskps((typename Register<N>::Float)mask.v) != 0;
#endif
    std::int32_t set = 0;
    for (std::size_t l = 0; l < N; ++l) set |= mask.v[l];
    return set != 0;
  } else {
    return any(mask.low | mask.high);
  }
}

/// Returns a bit for each lane in which the mask is set, lane 0 the lowest.
template <std::size_t N>
EMTR_INLINE std::uint32_t bits_of(const Ints<N>& mask) {
  if constexpr (one_register<N>()) {
#if defined(__AVX512DQ__)
    if constexpr (N == 16)
      return static_cast<std::uint32_t>(
          static_cast<std::uint16_t>(__builtin_ia32_cvtd2mask512(mask.v)));
#endif
#if defined(__AVX2__)
    if constexpr (N == 8)
      return static_cast<std::uint32_t>(
          __builtin_ia32_movmskps256((typename Register<N>::Float)mask.v));
#endif
#if defined(__SSE2__)
    if constexpr (N == 4)
      return static_cast<std::uint32_t>(
          __builtin_ia32_movmskps((typename Register<N>::Float)mask.v));
#endif
    std::uint32_t bits = 0;
    for (std::size_t l = 0; l < N; ++l) bits |= static_cast<std::uint32_t>(mask.v[l] & 1) << l;
    return bits;
  } else {
    return bits_of(mask.low) | bits_of(mask.high) << (N / 2);
  }
}

/// Returns the sum of eight, always in this order: (((0 + 4) + (2 + 6)) + ((1 + 5) + (3 + 7))).
EMTR_INLINE float sum_of(const Floats<8>& a) {
#if EMTR_REGISTER >= 8
  auto v = a.v, w = __builtin_shufflevector(v, v, 4, 5, 6, 7, 0, 1, 2, 3);
  v = v + w;
  w = __builtin_shufflevector(v, v, 2, 3, 0, 1, 6, 7, 4, 5);
  v = v + w;
  w = __builtin_shufflevector(v, v, 1, 0, 3, 2, 5, 4, 7, 6);
#else
  auto v = a.low.v + a.high.v, w = __builtin_shufflevector(v, v, 2, 3, 0, 1);
  v = v + w;
  w = __builtin_shufflevector(v, v, 1, 0, 3, 2);
#endif
  v = v + w;
  return v[0];
}

/// Returns a mask that is set in the lanes after lane k.
template <std::size_t N>
EMTR_INLINE Ints<N> lanes_after(std::int32_t k, std::int32_t first = 0) {
  if constexpr (one_register<N>()) {
    typename Register<N>::Int lane;
    for (std::size_t l = 0; l < N; ++l) lane[l] = first + static_cast<std::int32_t>(l);
    return {lane > k};
  } else {
    return {lanes_after<N / 2>(k, first),
            lanes_after<N / 2>(k, first + static_cast<std::int32_t>(N / 2))};
  }
}

/// Returns the minimum of eight.
EMTR_INLINE float minimum_of(const Floats<8>& a) {
#if EMTR_REGISTER >= 8
  auto v = a.v, w = __builtin_shufflevector(v, v, 4, 5, 6, 7, 0, 1, 2, 3);
  v = w < v ? w : v;
  w = __builtin_shufflevector(v, v, 2, 3, 0, 1, 6, 7, 4, 5);
  v = w < v ? w : v;
  w = __builtin_shufflevector(v, v, 1, 0, 3, 2, 5, 4, 7, 6);
#else
  auto v = minimum(a.low, a.high).v, w = __builtin_shufflevector(v, v, 2, 3, 0, 1);
  v = w < v ? w : v;
  w = __builtin_shufflevector(v, v, 1, 0, 3, 2);
#endif
  v = w < v ? w : v;
  return v[0];
}

/// Returns the minimum of sixteen.
EMTR_INLINE float minimum_of(const Floats<16>& a) {
#if EMTR_REGISTER >= 16
  const Floats<8> low = {__builtin_shufflevector(a.v, a.v, 0, 1, 2, 3, 4, 5, 6, 7)};
  const Floats<8> high = {__builtin_shufflevector(a.v, a.v, 8, 9, 10, 11, 12, 13, 14, 15)};
  return minimum_of(minimum(low, high));
#else
  return minimum_of(minimum(a.low, a.high));
#endif
}

/// Returns the minimum of each of four times eight.
EMTR_INLINE Floats<4> minimum_of_each(const Floats<8>* a) {
#if EMTR_REGISTER >= 8
  const auto halved = [](const auto& v, const auto& w) {  // pairs of v's lanes beside w's
    const auto even = __builtin_shufflevector(v, w, 0, 2, 8, 10, 4, 6, 12, 14);
    const auto odd = __builtin_shufflevector(v, w, 1, 3, 9, 11, 5, 7, 13, 15);
    return even < odd ? even : odd;
  };
  const auto v = halved(halved(a[0].v, a[1].v), halved(a[2].v, a[3].v));
  const auto low = __builtin_shufflevector(v, v, 0, 1, 2, 3);
  const auto high = __builtin_shufflevector(v, v, 4, 5, 6, 7);
  return {low < high ? low : high};
#else
  const auto halved = [](const auto& v, const auto& w) {
    const auto even = __builtin_shufflevector(v, w, 0, 2, 4, 6);
    const auto odd = __builtin_shufflevector(v, w, 1, 3, 5, 7);
    return even < odd ? even : odd;
  };
  const auto four = [&](int i) { return minimum(a[i].low, a[i].high).v; };
  return {halved(halved(four(0), four(1)), halved(four(2), four(3)))};
#endif
}

}  // namespace emtr::EMTR_KERNEL
