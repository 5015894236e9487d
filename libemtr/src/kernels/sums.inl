// Motion of points and the sums of both fitness functions. Included by each instruction set's file.

namespace emtr::EMTR_KERNEL {
namespace {

constexpr std::size_t kWide = 16;  // lanes of those sums that have no candidates to look at
using Sixteen = Floats<kWide>;

void transform(const PointsView& p, const float* R, const float* t, float* x, float* y, float* z) {
  float* out[3] = {x, y, z};
  std::size_t i = 0;
  for (; i + kWide <= p.size; i += kWide) {
    const Sixteen px = loaded<kWide>(p.x + i);
    const Sixteen py = loaded<kWide>(p.y + i);
    const Sixteen pz = loaded<kWide>(p.z + i);
    for (int a = 0; a < 3; ++a)
      store<kWide, Floats>(out[a] + i,
                           ((all<kWide>(R[3 * a]) * px + all<kWide>(R[3 * a + 1]) * py) +
                            all<kWide>(R[3 * a + 2]) * pz) +
                               all<kWide>(t[a]));
  }
  for (; i < p.size; ++i) {
    const float px = p.x[i], py = p.y[i], pz = p.z[i];
    for (int a = 0; a < 3; ++a)
      out[a][i] = ((R[3 * a] * px + R[3 * a + 1] * py) + R[3 * a + 2] * pz) + t[a];
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

/// |q - R p|^2 of sixteen TIMs.
EMTR_INLINE Sixteen squared_residuals(const PointsView& p, const PointsView& q, const float* R,
                                      std::size_t i) {
  const Sixteen px = loaded<kWide>(p.x + i), qx = loaded<kWide>(q.x + i);
  const Sixteen py = loaded<kWide>(p.y + i), qy = loaded<kWide>(q.y + i);
  const Sixteen pz = loaded<kWide>(p.z + i), qz = loaded<kWide>(q.z + i);
  const auto r = [R](int k) { return all<kWide>(R[k]); };
  const Sixteen dx = ((r(0) * px + r(1) * py) + r(2) * pz) - qx;
  const Sixteen dy = ((r(3) * px + r(4) * py) + r(5) * pz) - qy;
  const Sixteen dz = ((r(6) * px + r(7) * py) + r(8) * pz) - qz;
  return (dx * dx + dy * dy) + dz * dz;
}

EMTR_INLINE void add_inliers(const Sixteen& squared, float squared_threshold, Ints<kWide>& count,
                             Sixteen& sum) {
  const Ints<kWide> inlier = squared < all<kWide>(squared_threshold);  // all bits set, or none
  sum = sum + masked(root(squared), inlier);
  count = count - inlier;
}

Consensus consensus(const PointsView& p, const PointsView& q, const float* R,
                    float squared_threshold) {
  constexpr std::size_t block = 512;  // summed in float before they go to double
  Consensus out = {0, 0};
  for (std::size_t begin = 0; begin < p.size; begin += block) {
    const std::size_t end = begin + block < p.size ? begin + block : p.size;
    Ints<kWide> count = {};
    Sixteen sum = {};
    std::size_t i = begin;
    for (; i + kWide <= end; i += kWide)
      add_inliers(squared_residuals(p, q, R, i), squared_threshold, count, sum);
    if (i < end) {  // fewer than sixteen are left: the others become outliers
      float rest[6][kWide];
      const float* from[6] = {p.x, p.y, p.z, q.x, q.y, q.z};
      for (int a = 0; a < 6; ++a)
        for (std::size_t l = 0; l < kWide; ++l)
          rest[a][l] = i + l < end ? from[a][i + l] : (a < 3 ? 0.0f : 1e18f);
      const PointsView p_rest = {rest[0], rest[1], rest[2], kWide};
      const PointsView q_rest = {rest[3], rest[4], rest[5], kWide};
      add_inliers(squared_residuals(p_rest, q_rest, R, 0), squared_threshold, count, sum);
    }
    std::int32_t counts[kWide];
    float sums[kWide];
    store<kWide, Ints>(counts, count);
    store<kWide, Floats>(sums, sum);
    for (std::size_t l = 0; l < kWide; ++l) {
      out.inliers += static_cast<double>(counts[l]);
      out.residuals += static_cast<double>(sums[l]);
    }
  }
  return out;
}

}  // namespace
}  // namespace emtr::EMTR_KERNEL
