// Sums over matched pairs, see refinement/plane_to_plane. Included by each instruction set's file.

#include "kernels/doubles.inl"
#include "kernels/search_kernels.h"

namespace emtr::EMTR_KERNEL {
namespace {

/// Returns `a` where the mask is set, else 0.
EMTR_INLINE Doubles where(const DoublesMask& mask, const Doubles& a) {
  return (Doubles)((DoublesMask)a & mask);
}

EMTR_INLINE Doubles magnitudes(const Doubles& a) { return (Doubles)((DoublesMask)a & INT64_MAX); }

/// Sums of pairs side by side.
struct PairSums {
  Doubles H[21], g[6], tangents[10], weights, squares, squared_influence, slopes, inliers;
};

/// Writes R v, to which it adds t where there is one.
EMTR_INLINE void moved(const PlaneToPlaneView& at, const Doubles v[3], const double* t,
                       Doubles out[3]) {
  for (int a = 0; a < 3; ++a) {
    out[a] = v[0] * at.R[3 * a] + v[1] * at.R[3 * a + 1] + v[2] * at.R[3 * a + 2];
    if (t) out[a] += t[a];
  }
}

EMTR_INLINE void add_normals(const Doubles J[6], const Doubles& e, const Doubles& w,
                             PairSums& sums) {
  Doubles* h = sums.H;
  for (int i = 0; i < 6; ++i) {
    const Doubles wJ = w * J[i];
    sums.g[i] += wJ * e;
    for (int j = i; j < 6; ++j) *h++ += wJ * J[j];
  }
}

EMTR_INLINE void add_differences(const Doubles y[3], const Doubles d[3], const Doubles& w,
                                 PairSums& sums) {
  const Doubles wy[3] = {w * y[0], w * y[1], w * y[2]}, wd[3] = {w * d[0], w * d[1], w * d[2]};
  sums.tangents[0] += w;
  Doubles* yy = sums.tangents + 4;
  for (int i = 0; i < 3; ++i) {
    sums.tangents[1 + i] += wy[i];
    for (int j = i; j < 3; ++j) *yy++ += wy[i] * y[j];
    sums.g[3 + i] += wd[i];
  }
  sums.g[0] += y[1] * wd[2] - y[2] * wd[1];
  sums.g[1] += y[2] * wd[0] - y[0] * wd[2];
  sums.g[2] += y[0] * wd[1] - y[1] * wd[0];
}

/// Adds the pairs from row i on. The same steps as PlaneToPlane::add(); those that leave out a pair
/// there make its weights 0 here.
EMTR_INLINE void add_pairs(const PairsView& pairs, const PlaneToPlaneView& at, std::size_t i,
                           PairSums& sums) {
  Doubles p[3], q[3], n[3], from[3], y[3], d[3], m[3], v[3];
  for (int a = 0; a < 3; ++a) {
    p[a] = load_doubles(pairs.source[a] + i);
    q[a] = load_doubles(pairs.target[a] + i);
    n[a] = load_doubles(pairs.target[3 + a] + i);
    from[a] = load_doubles(pairs.source[3 + a] + i);
  }
  moved(at, p, at.t, y);
  moved(at, from, nullptr, m);
  Doubles cosine = m[0] * n[0] + m[1] * n[1] + m[2] * n[2];
  const DoublesMask alike = magnitudes(cosine) > at.gate;  // not for a NaN either
  cosine = where(alike, cosine);
  const Doubles c = magnitudes(cosine);
  const Doubles sign = cosine < 0 ? Doubles{} - 1 : Doubles{} + 1;
  for (int a = 0; a < 3; ++a) {
    d[a] = y[a] - q[a];
    v[a] = where(alike, n[a] + sign * m[a]);
  }
  const double eps = at.softness;
  const Doubles squared_length = 2 + 2 * c, variance = 2 * eps + (1 - eps) * (1 - c);
  const Doubles inverse = 1 / (squared_length * variance);
  const Doubles along = 2 * eps * squared_length * inverse - eps;
  const Doubles e = v[0] * d[0] + v[1] * d[1] + v[2] * d[2];
  const Doubles squared = e * e * variance * inverse;
  const Doubles cost = along * squared + eps * (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
  Doubles bend = 1 - cost * at.inverse_squared_scale;
  const DoublesMask inlier = alike & (bend > 0);
  bend = where(inlier, bend);
  const Doubles tukey = bend * bend, w = tukey * along;
  const Doubles J[6] = {y[1] * v[2] - y[2] * v[1],
                        y[2] * v[0] - y[0] * v[2],
                        y[0] * v[1] - y[1] * v[0],
                        v[0],
                        v[1],
                        v[2]};
  add_normals(J, e, w * variance * inverse, sums);
  add_differences(y, d, tukey * eps, sums);
  sums.weights += w;
  sums.squares += w * squared;
  sums.squared_influence += w * w * squared;
  sums.slopes += along * bend * (bend - 4 * along * squared * at.inverse_squared_scale);
  sums.inliers += where(inlier, Doubles{} + 1);
}

void plane_to_plane(const PairsView& pairs, const PlaneToPlaneView& at, double* out) {
  static_assert(sizeof(PairSums) == kPairSums * sizeof(Doubles), "as many sums as are written");
  constexpr std::size_t parts = kLanes / kDoubles;
  double lanes[parts][kPairSums][kDoubles];
  for (std::size_t part = 0; part < parts; ++part) {
    PairSums sums = {};
    for (std::size_t i = part * kDoubles; i < pairs.size; i += kLanes)
      add_pairs(pairs, at, i, sums);
    __builtin_memcpy(lanes[part], &sums, sizeof sums);
  }
  for (std::size_t k = 0; k < kPairSums; ++k) {
    double each[kLanes];
    for (std::size_t l = 0; l < kLanes; ++l) each[l] = lanes[l / kDoubles][k][l % kDoubles];
    out[k] = total_of_lanes(each);
  }
}

}  // namespace
}  // namespace emtr::EMTR_KERNEL
