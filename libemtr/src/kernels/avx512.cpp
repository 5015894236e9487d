#define EMTR_KERNEL avx512
#include "consensus.inl"
#include "nearest.inl"
#include "sums.inl"
#include "voxels.inl"

namespace emtr {
extern const Kernels k_avx512;
const Kernels k_avx512 = {"avx512",
                          avx512::transform,
                          avx512::squared_distances,
                          avx512::nearest,
                          avx512::voxel_squared_distances,
                          avx512::voxel_nearest,
                          avx512::rho_sum,
                          avx512::consensus};
}  // namespace emtr
