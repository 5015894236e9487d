#define EMTR_KERNEL avx512
#include "descriptors.inl"
#include "lanes.h"
#include "matching.inl"
#include "nearest.inl"
#include "sums.inl"

namespace emtr {
extern const Kernels k_avx512;
const Kernels k_avx512 = {"avx512",
                          avx512::transform,
                          avx512::squared_distances,
                          avx512::nearest,
                          avx512::rho_sum,
                          avx512::consensus,
                          avx512::moments,
                          avx512::least_directions,
                          avx512::pair_histograms,
                          avx512::weighted_histograms,
                          avx512::least_squared,
                          avx512::nearest_descriptors};
}  // namespace emtr
