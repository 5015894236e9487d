#define EMTR_KERNEL generic
#include "consensus.inl"
#include "nearest.inl"
#include "sums.inl"
#include "voxels.inl"

namespace emtr {
extern const Kernels k_generic;
const Kernels k_generic = {"generic",
                           generic::transform,
                           generic::squared_distances,
                           generic::nearest,
                           generic::voxel_squared_distances,
                           generic::voxel_nearest,
                           generic::rho_sum,
                           generic::consensus};
}  // namespace emtr
