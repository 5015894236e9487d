#pragma once

#include <emtr/emtr.h>

#include <new>
#include <random>
#include <vector>

#include "bumpy_pair.h"
#include "geometry/cloud.h"

namespace emtr_test {

/// A generated pair that frees itself, with the views that the library takes.
class Pair {
 public:
  explicit Pair(std::uint64_t seed, std::size_t points = 6000, double unit = 1) {
    if (bumpy_pair_make(&pair_, seed, points, unit)) throw std::bad_alloc();
  }
  ~Pair() { bumpy_pair_free(&pair_); }
  Pair(const Pair&) = delete;
  Pair& operator=(const Pair&) = delete;

  emtr_cloud source() const { return {pair_.source, pair_.count, 0, EMTR_FLOAT32}; }
  emtr_cloud target() const { return {pair_.target, pair_.count, 0, EMTR_FLOAT32}; }
  double error(const double T[16]) const { return bumpy_pair_error(&pair_, T); }
  const double* pose() const { return pair_.pose; }
  double unit() const { return pair_.unit; }

 private:
  bumpy_pair pair_;
};

/// The kernels that this machine can run.
inline std::vector<const emtr::Kernels*> kernels_here() {
  std::vector<const emtr::Kernels*> out;
  for (std::size_t i = 0; const emtr::Kernels* kernels = emtr::kernels_at(i); ++i)
    if (emtr::can_run(*kernels)) out.push_back(kernels);
  return out;
}

inline void push(emtr::Cloud& cloud, float x, float y, float z) {
  cloud.x.push_back(x);
  cloud.y.push_back(y);
  cloud.z.push_back(z);
}

/// n points in a box, uniform.
inline emtr::Cloud uniform_cloud(std::size_t n, unsigned seed, float half = 1, float flat = 1) {
  std::mt19937 random(seed);
  const auto draw = [&] {
    return static_cast<float>(random()) / 2147483648.0f - 1;  // of [-1, 1]
  };
  emtr::Cloud cloud;
  for (std::size_t i = 0; i < n; ++i) {
    const float x = half * draw(), y = half * draw(), z = half * flat * draw();
    push(cloud, x, y, z);
  }
  return cloud;
}

}  // namespace emtr_test
