// Computes normals and point feature histograms over lists of neighbors. Included by each
// instruction set's file. Nothing here calls the mathematics library, whose functions differ
// between machines.

#include "kernels/lanes.h"

namespace emtr::EMTR_KERNEL {
namespace {

constexpr std::size_t kNative = EMTR_REGISTER;  // lanes of numbers that no sum goes across
constexpr std::size_t kChunk = 512;             // points of a list between two passes over it
using Native = Floats<kNative>;
using NativeInts = Ints<kNative>;

template <std::size_t N>
struct Vector {
  Floats<N> x, y, z;
};

template <std::size_t N>
EMTR_INLINE Vector<N> vector_from(const float* x, const float* y, const float* z) {
  return {load<N>(x), load<N>(y), load<N>(z)};
}
template <std::size_t N>
EMTR_INLINE Vector<N> vector_of(float x, float y, float z) {
  return {broadcast<N>(x), broadcast<N>(y), broadcast<N>(z)};
}
template <std::size_t N>
EMTR_INLINE Vector<N> operator-(const Vector<N>& a, const Vector<N>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <std::size_t N>
EMTR_INLINE Floats<N> dot(const Vector<N>& a, const Vector<N>& b) {
  return (a.x * b.x + a.y * b.y) + a.z * b.z;
}
template <std::size_t N>
EMTR_INLINE Vector<N> cross(const Vector<N>& a, const Vector<N>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <std::size_t N>
EMTR_INLINE Vector<N> blend(const Ints<N>& mask, const Vector<N>& a, const Vector<N>& b) {
  return {blend(mask, a.x, b.x), blend(mask, a.y, b.y), blend(mask, a.z, b.z)};
}

void moments(const PointsView& list, const float* query, float squared_radius, float* out,
             std::size_t stride) {
  const Vector<kLanes> q = vector_of<kLanes>(query[0], query[1], query[2]);
  Floats<kLanes> sum[kMoments] = {};
  for (std::size_t i = 0; i < list.size; i += kLanes) {
    const Vector<kLanes> d = vector_from<kLanes>(list.x + i, list.y + i, list.z + i) - q;
    const Ints<kLanes> near = dot(d, d) < broadcast<kLanes>(squared_radius);
    const Floats<kLanes> x = masked(d.x, near), y = masked(d.y, near), z = masked(d.z, near);
    sum[0] = sum[0] + masked(broadcast<kLanes>(1.0f), near);
    sum[1] = sum[1] + x;
    sum[2] = sum[2] + y;
    sum[3] = sum[3] + z;
    sum[4] = sum[4] + x * x;
    sum[5] = sum[5] + x * y;
    sum[6] = sum[6] + x * z;
    sum[7] = sum[7] + y * y;
    sum[8] = sum[8] + y * z;
    sum[9] = sum[9] + z * z;
  }
  for (std::size_t m = 0; m < kMoments; ++m) out[m * stride] = sum_of(sum[m]);
}

// Applies one Jacobi rotation to a symmetric matrix, which makes a_pq zero; r is the third axis.
EMTR_INLINE void rotate(Native& pp, Native& qq, Native& pq, Native& rp, Native& rq,
                        Vector<kNative>& p, Vector<kNative>& q) {
  const Native one = broadcast<kNative>(1.0f), two = broadcast<kNative>(2.0f);
  const Native difference = qq - pp, twice = two * pq;
  // tan of the angle; the tiny number makes it 0 where there is nothing to rotate
  const Native size = magnitude(difference) + root(difference * difference + twice * twice) +
                      broadcast<kNative>(1e-37f);
  const Native t = flip_signs(twice / size, sign_of(difference));
  const Native c = one / root(t * t + one), s = t * c;
  pp = pp - t * pq;
  qq = qq + t * pq;
  pq = Native{};
  const Native old = rp;
  rp = c * old - s * rq;
  rq = s * old + c * rq;
  const Vector<kNative> before = p;
  p = {c * before.x - s * q.x, c * before.y - s * q.y, c * before.z - s * q.z};
  q = {s * before.x + c * q.x, s * before.y + c * q.y, s * before.z + c * q.z};
}

EMTR_INLINE Native greater_of(const Native& a, const Native& b) { return blend(a < b, b, a); }

/// Returns the normals of kNative neighborhoods: the directions of the smallest variance.
EMTR_INLINE Vector<kNative> plane_normal(const float* moments, std::size_t stride) {
  const Native one = broadcast<kNative>(1.0f), count = load<kNative>(moments);
  const auto mean = [&](std::size_t m) { return load<kNative>(moments + m * stride) / count; };
  const Native x = mean(1), y = mean(2), z = mean(3);
  Native xx = mean(4) - x * x, xy = mean(5) - x * y, xz = mean(6) - x * z;
  Native yy = mean(7) - y * y, yz = mean(8) - y * z, zz = mean(9) - z * z;

  const Native trace = (xx + yy) + zz;
  const Ints<kNative> some = broadcast<kNative>(0.0f) < trace;
  const Native scale = one / blend(some, trace, one);
  xx = xx * scale, xy = xy * scale, xz = xz * scale;
  yy = yy * scale, yz = yz * scale, zz = zz * scale;
  Vector<kNative> a = vector_of<kNative>(1, 0, 0), b = vector_of<kNative>(0, 1, 0),
                  c = vector_of<kNative>(0, 0, 1);
#pragma GCC unroll 1
  for (int sweep = 0; sweep < 4; ++sweep) {
    rotate(xx, yy, xy, xz, yz, a, b);
    rotate(xx, zz, xz, xy, yz, a, c);
    rotate(yy, zz, yz, xy, xz, b, c);
  }
  // Takes the smallest of the three if the next one is clearly greater.
  const Ints<kNative> swap_ab = yy < xx;
  const Native low = blend(swap_ab, yy, xx), high = blend(swap_ab, xx, yy);
  const Vector<kNative> first = blend(swap_ab, b, a);
  const Ints<kNative> swap_c = zz < low;
  const Native smallest = blend(swap_c, zz, low);
  const Native next = blend(swap_c, low, minimum(high, zz));
  Vector<kNative> n = blend(swap_c, c, first);
  const Ints<kNative> clear =
      (broadcast<kNative>(1e-6f) < next - smallest) & some & (count >= broadcast<kNative>(3.0f));
  const Native length = one / root(dot(n, n));
  const Native none = broadcast<kNative>(__builtin_nanf(""));
  return {blend(clear, n.x * length, none), blend(clear, n.y * length, none),
          blend(clear, n.z * length, none)};
}

EMTR_INLINE void plane_normals_of(const float* moments, std::size_t stride, const float* x,
                                  const float* y, const float* z, const float* viewpoint, float* nx,
                                  float* ny, float* nz) {
  Vector<kNative> n = plane_normal(moments, stride);
  const Vector<kNative> towards =
      vector_of<kNative>(viewpoint[0], viewpoint[1], viewpoint[2]) - vector_from<kNative>(x, y, z);
  const Ints<kNative> away = dot(towards, n) < broadcast<kNative>(0.0f);
  const Ints<kNative> sign = away & broadcast<kNative>(static_cast<std::int32_t>(-0x7fffffff - 1));
  store<kNative, Floats>(nx, flip_signs(n.x, sign));
  store<kNative, Floats>(ny, flip_signs(n.y, sign));
  store<kNative, Floats>(nz, flip_signs(n.z, sign));
}

void plane_normals(const float* moments, std::size_t stride, const PointsView& points,
                   const float* viewpoint, float* nx, float* ny, float* nz) {
  std::size_t i = 0;
  for (; i + kNative <= points.size; i += kNative)
    plane_normals_of(moments + i, stride, points.x + i, points.y + i, points.z + i, viewpoint,
                     nx + i, ny + i, nz + i);
  if (i == points.size) return;
  float rest[kMoments][kNative] = {}, point[3][kNative] = {}, normal[3][kNative];
  for (std::size_t l = 0; i + l < points.size; ++l) {
    for (std::size_t m = 0; m < kMoments; ++m) rest[m][l] = moments[m * stride + i + l];
    point[0][l] = points.x[i + l];
    point[1][l] = points.y[i + l];
    point[2][l] = points.z[i + l];
  }
  plane_normals_of(rest[0], kNative, point[0], point[1], point[2], viewpoint, normal[0], normal[1],
                   normal[2]);
  for (std::size_t l = 0; i + l < points.size; ++l) {
    nx[i + l] = normal[0][l];
    ny[i + l] = normal[1][l];
    nz[i + l] = normal[2][l];
  }
}

// Returns the bins of the three angles of a pair (Rusu's Darboux frame) as bytes of an integer: the
// angle of the normals in the frame, the cosine to its second axis, the cosine to the line between
// the points. The bytes are past the bins where the two are no pair; `near` counts (negatively) the
// points nearer than the radius, the query itself among them.
EMTR_INLINE NativeInts pair_bins(const SurfaceView& list, std::size_t i,
                                 const Vector<kNative>& point, const Vector<kNative>& normal,
                                 const Native& squared_radius, NativeInts& near) {
  const Native zero = broadcast<kNative>(0.0f), one = broadcast<kNative>(1.0f);
  const auto number = [](std::int32_t value) { return broadcast<kNative>(value); };
  const Vector<kNative> d =
      vector_from<kNative>(list.points.x + i, list.points.y + i, list.points.z + i) - point;
  const Vector<kNative> other = vector_from<kNative>(list.nx + i, list.ny + i, list.nz + i);
  const Native squared = dot(d, d);
  const NativeInts inside = squared < squared_radius;
  near = near + inside;

  // Bases the frame on the normal that is closer to the line between the points, and on the query's
  // own when both are alike: two points with the same neighbors have the same normal but for
  // rounding, which must not decide.
  const Native length = root(squared);
  const Native along = dot(normal, d), along_other = dot(other, d), cosine = dot(normal, other);
  const NativeInts swapped =
      magnitude(along) + length * broadcast<kNative>(1e-5f) < magnitude(along_other);
  const NativeInts sign = swapped & number(-0x7fffffff - 1);
  const Vector<kNative> v = cross(d, blend(swapped, other, normal));
  const Native v_squared = dot(v, v);
  const NativeInts pair = inside & (zero < squared) & (zero < v_squared);
  const Native v_length = root(v_squared);

  // The angle atan2(sine, cosine) falls into the bins between tangents of odd multiples of pi / 11.
  const Native first = blend(swapped, along_other, along);
  const Native second = blend(swapped, along, along_other);
  const Native sine = flip_signs(second - cosine * first, sign), height = magnitude(sine);
  const Native width = cosine * v_length;
  const NativeInts edges = ((height >= width * broadcast<kNative>(0.293626493f)) +
                            (height >= width * broadcast<kNative>(1.15406152f))) +
                           ((height >= width * broadcast<kNative>(6.95515277f)) +
                            (width * broadcast<kNative>(-2.18969456f) >= height)) +
                           (width * broadcast<kNative>(-0.642660977f) >= height);
  const NativeInts below = edges & (sine < zero);
  const NativeInts bin1 = (number(5) - edges) + (below + below);

  const Native middle = broadcast<kNative>(5.5f), last = broadcast<kNative>(10.5f);
  const Vector<kNative> rest = blend(swapped, normal, other);
  const Native f2 = flip_signs(dot(v, rest) / v_length, sign);
  const Native f3 = flip_signs(first / length, sign);
  const NativeInts bin2 = truncated(minimum(last, masked((f2 + one) * middle, pair)));
  const NativeInts bin3 = truncated(minimum(last, masked((f3 + one) * middle, pair)));
  const NativeInts bins = bin1 + byte_up(bin2 + byte_up(bin3 + number(0x0f00)));
  return (bins & pair) | (number(0x0f0f0f0f) & ~pair);
}

typedef std::uint8_t Bytes __attribute__((vector_size(4 * kNative)));
typedef std::uint32_t Words __attribute__((vector_size(4 * kNative)));

EMTR_INLINE std::uint32_t total(const Words& words) {
  std::uint32_t each[kNative], sum = 0;
  __builtin_memcpy(each, &words, sizeof each);
  for (const std::uint32_t word : each) sum += word;
  return sum;
}

/// Adds to count[histogram][bin] how often each byte occurs.
EMTR_INLINE void count_bins(const std::int32_t* bins, std::size_t n,
                            std::uint32_t (*count)[kBins]) {
  static_assert(kChunk / kNative < 256, "bytes hold the counts");
  Bytes sum[kBins] = {};
  for (std::size_t i = 0; i < n; i += kNative) {
    Bytes found;
    __builtin_memcpy(&found, bins + i, sizeof found);
#pragma GCC unroll 11
    for (std::size_t b = 0; b < kBins; ++b)
      sum[b] -= (Bytes)(found == static_cast<std::uint8_t>(b));
  }
#pragma GCC unroll 11
  for (std::size_t b = 0; b < kBins; ++b) {
    const std::uint32_t even = total((Words)sum[b] & 0x00ff00ffu);
    const std::uint32_t odd = total(((Words)sum[b] >> 8) & 0x00ff00ffu);
    count[0][b] += even & 0xffffu;
    count[1][b] += odd & 0xffffu;
    count[2][b] += even >> 16;
  }
}

void pair_histograms(const SurfaceView& list, const SurfacePoint& query, float squared_radius,
                     float* out) {
  const Vector<kNative> point = vector_of<kNative>(query.p[0], query.p[1], query.p[2]);
  const Vector<kNative> normal = vector_of<kNative>(query.n[0], query.n[1], query.n[2]);
  const Native radius = broadcast<kNative>(squared_radius);
  std::uint32_t count[3][kBins] = {};
  NativeInts near = {};
  for (std::size_t begin = 0; begin < list.points.size; begin += kChunk) {
    const std::size_t left = list.points.size - begin, n = left < kChunk ? left : kChunk;
    std::int32_t bins[kChunk];
    for (std::size_t i = 0; i < n; i += kNative)
      store<kNative, Ints>(bins + i, pair_bins(list, begin + i, point, normal, radius, near));
    count_bins(bins, n, count);
  }
  std::int32_t each[kNative], neighbors = 0;
  store<kNative, Ints>(each, near);
  for (const std::int32_t one : each) neighbors -= one;
  const float share = neighbors > 1 ? 100.0f / static_cast<float>(neighbors - 1) : 0.0f;
  for (std::size_t b = 0; b < kDescriptor; ++b)
    // NOLINTNEXTLINE(bugprone-integer-division): an index
    out[b] = static_cast<float>(count[b / kBins][b % kBins]) * share;
  for (std::size_t b = kDescriptor; b < kDescriptorRow; ++b) out[b] = 0;
}

void weighted_histograms(const PointsView& list, const std::uint32_t* rows, const float* query,
                         float squared_radius, const float* histograms, float* out) {
  constexpr std::size_t head = 32;
  const Vector<kNative> q = vector_of<kNative>(query[0], query[1], query[2]);
  Floats<head> sum = {};
  Floats<kDescriptorRow - head> rest = {};
  for (std::size_t begin = 0; begin < list.size; begin += kChunk) {
    const std::size_t end = list.size - begin < kChunk ? list.size : begin + kChunk;
    float weight[kChunk], other_weight[kChunk + 1];
    std::uint32_t row[kChunk + 1];
    for (std::size_t i = begin; i < end; i += kNative) {
      const Vector<kNative> d = vector_from<kNative>(list.x + i, list.y + i, list.z + i) - q;
      const Native squared = dot(d, d);
      const NativeInts other =
          (squared < broadcast<kNative>(squared_radius)) & (broadcast<kNative>(0.0f) < squared);
      store<kNative, Floats>(weight + (i - begin),
                             masked(broadcast<kNative>(1.0f) / squared, other));
    }
    std::size_t n = 0;
    for (std::size_t i = begin; i < end; ++i) {  // without a branch: half of them are neighbors
      other_weight[n] = weight[i - begin];
      row[n] = rows[i];
      n += other_weight[n] != 0.0f;
    }
    for (std::size_t k = 0; k < n; ++k) {
      const float* histogram = histograms + kDescriptorRow * static_cast<std::size_t>(row[k]);
      sum = sum + broadcast<head>(other_weight[k]) * load<head>(histogram);
      rest = rest + broadcast<kDescriptorRow - head>(other_weight[k]) *
                        load<kDescriptorRow - head>(histogram + head);
    }
  }
  float bins[kDescriptorRow];
  store<head, Floats>(bins, sum);
  store<kDescriptorRow - head, Floats>(bins + head, rest);
  for (std::size_t part = 0; part < kDescriptor; part += kBins) {
    double whole = 0;
    for (std::size_t b = 0; b < kBins; ++b) whole += static_cast<double>(bins[part + b]);
    if (whole != 0) whole = 100.0 / whole;
    for (std::size_t b = 0; b < kBins; ++b)
      out[part + b] = static_cast<float>(static_cast<double>(bins[part + b]) * whole);
  }
}

float minimum_squared_distance(const PointsView& list, const float* query) {
  const Vector<kLanes> q = vector_of<kLanes>(query[0], query[1], query[2]);
  Floats<kLanes> best = broadcast<kLanes>(__builtin_inff());
  for (std::size_t i = 0; i < list.size; i += kLanes) {
    const Vector<kLanes> d = vector_from<kLanes>(list.x + i, list.y + i, list.z + i) - q;
    best = minimum(best, dot(d, d));
  }
  return minimum_of(best);
}

}  // namespace
}  // namespace emtr::EMTR_KERNEL
