#define EMTR_KERNEL avx2
#include "consensus.inl"
#include "nearest.inl"
#include "sums.inl"
#include "voxels.inl"

namespace emtr {
extern const Kernels k_avx2;
const Kernels k_avx2 = {"avx2",
                        avx2::transform,
                        avx2::squared_distances,
                        avx2::nearest,
                        avx2::voxel_squared_distances,
                        avx2::voxel_nearest,
                        avx2::rho_sum,
                        avx2::consensus};
}  // namespace emtr
