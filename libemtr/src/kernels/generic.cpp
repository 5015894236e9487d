#define EMTR_KERNEL generic
#include "consensus.inl"
#include "lanes.h"
#include "nearest.inl"
#include "sums.inl"

namespace emtr {
extern const Kernels k_generic;
const Kernels k_generic = {"generic",        generic::transform, generic::squared_distances,
                           generic::nearest, generic::rho_sum,   generic::consensus};
}  // namespace emtr
