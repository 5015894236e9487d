#define EMTR_KERNEL generic
#include "lanes.h"
#include "nearest.inl"
#include "sums.inl"
#include "consistency.inl"

namespace emtr {
extern const Kernels k_generic;
const Kernels k_generic = {"generic",        generic::transform, generic::squared_distances,
                           generic::nearest, generic::rho_sum,   generic::consensus, generic::consistent, generic::count_common};
}  // namespace emtr
