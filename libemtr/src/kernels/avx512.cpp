#define EMTR_KERNEL avx512
#include "lanes.h"
#include "nearest.inl"
#include "sums.inl"
#include "consistency.inl"

namespace emtr {
extern const Kernels k_avx512;
const Kernels k_avx512 = {"avx512",        avx512::transform, avx512::squared_distances,
                          avx512::nearest, avx512::rho_sum,   avx512::consensus, avx512::consistent, avx512::count_common};
}  // namespace emtr
