// Motion of points and the sums of both fitness functions. Included by each instruction set's file.

namespace emtr::EMTR_KERNEL {
namespace {

void transform(const PointsView& p, const float* R, const float* t, float* x, float* y, float* z) {
  for (std::size_t i = 0; i < p.size; ++i) {
    const float px = p.x[i], py = p.y[i], pz = p.z[i];
    x[i] = ((R[0] * px + R[1] * py) + R[2] * pz) + t[0];
    y[i] = ((R[3] * px + R[4] * py) + R[5] * pz) + t[1];
    z[i] = ((R[6] * px + R[7] * py) + R[8] * pz) + t[2];
  }
}

EMTR_INLINE double rho(float squared, float inverse) {
  const float w = 1.0f - squared * inverse;
  return static_cast<double>(1.0f - w * w * w);
}

double rho_sum(const float* squared, std::size_t n, float inverse) {
  double sum[kLanes] = {};
  std::size_t i = 0;
  for (; i + kLanes <= n; i += kLanes)
    for (std::size_t l = 0; l < kLanes; ++l) sum[l] += rho(squared[i + l], inverse);
  for (std::size_t l = 0; i < n; ++i, ++l) sum[l] += rho(squared[i], inverse);
  return ((sum[0] + sum[4]) + (sum[2] + sum[6])) + ((sum[1] + sum[5]) + (sum[3] + sum[7]));
}

/// |q - R p|^2 of eight TIMs.
EMTR_INLINE Floats squared_residuals(const PointsView& p, const PointsView& q, const float* R,
                                     std::size_t i) {
  const Floats px = loaded<Floats>(p.x + i), qx = loaded<Floats>(q.x + i);
  const Floats py = loaded<Floats>(p.y + i), qy = loaded<Floats>(q.y + i);
  const Floats pz = loaded<Floats>(p.z + i), qz = loaded<Floats>(q.z + i);
  const Floats dx = ((R[0] * px + R[1] * py) + R[2] * pz) - qx;
  const Floats dy = ((R[3] * px + R[4] * py) + R[5] * pz) - qy;
  const Floats dz = ((R[6] * px + R[7] * py) + R[8] * pz) - qz;
  return (dx * dx + dy * dy) + dz * dz;
}

EMTR_INLINE void add_inliers(const Floats& squared, float squared_threshold, Ints& count,
                             Floats& sum) {
  const Ints inlier = squared < all(squared_threshold);  // all bits set, or none
  float roots[kLanes];
  store(roots, squared);
  for (float& root : roots) root = __builtin_sqrtf(root);
  sum = sum + masked(loaded<Floats>(roots), inlier);
  count = count - inlier;
}

Consensus consensus(const PointsView& p, const PointsView& q, const float* R,
                    float squared_threshold) {
  constexpr std::size_t block = 512;  // summed in float before they go to double
  Consensus out = {0, 0};
  for (std::size_t begin = 0; begin < p.size; begin += block) {
    const std::size_t end = begin + block < p.size ? begin + block : p.size;
    Ints count = {};
    Floats sum = {};
    std::size_t i = begin;
    for (; i + kLanes <= end; i += kLanes)
      add_inliers(squared_residuals(p, q, R, i), squared_threshold, count, sum);
    if (i < end) {  // fewer than eight are left: the others become outliers
      float rest[6][kLanes];
      const float* from[6] = {p.x, p.y, p.z, q.x, q.y, q.z};
      for (int a = 0; a < 6; ++a)
        for (std::size_t l = 0; l < kLanes; ++l)
          rest[a][l] = i + l < end ? from[a][i + l] : (a < 3 ? 0.0f : 1e18f);
      const PointsView p_rest = {rest[0], rest[1], rest[2], kLanes};
      const PointsView q_rest = {rest[3], rest[4], rest[5], kLanes};
      add_inliers(squared_residuals(p_rest, q_rest, R, 0), squared_threshold, count, sum);
    }
    std::int32_t counts[kLanes];
    float sums[kLanes];
    store(counts, count);
    store(sums, sum);
    for (std::size_t l = 0; l < kLanes; ++l) {
      out.inliers += static_cast<double>(counts[l]);
      out.residuals += static_cast<double>(sums[l]);
    }
  }
  return out;
}

}  // namespace
}  // namespace emtr::EMTR_KERNEL
