#define EMTR_KERNEL avx512
#include "consensus.inl"
#include "lanes.h"
#include "nearest.inl"
#include "sums.inl"

namespace emtr {
extern const Kernels k_avx512;
const Kernels k_avx512 = {"avx512",        avx512::transform, avx512::squared_distances,
                          avx512::nearest, avx512::rho_sum,   avx512::consensus};
}  // namespace emtr
