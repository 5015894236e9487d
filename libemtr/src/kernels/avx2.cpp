#define EMTR_KERNEL avx2
#include "descriptors.inl"
#include "lanes.h"
#include "matching.inl"
#include "nearest.inl"
#include "sums.inl"

namespace emtr {
extern const Kernels k_avx2;
const Kernels k_avx2 = {"avx2",
                        avx2::transform,
                        avx2::squared_distances,
                        avx2::nearest,
                        avx2::rho_sum,
                        avx2::consensus,
                        avx2::moments,
                        avx2::least_directions,
                        avx2::pair_histograms,
                        avx2::weighted_histograms,
                        avx2::least_squared,
                        avx2::nearest_descriptors};
}  // namespace emtr
