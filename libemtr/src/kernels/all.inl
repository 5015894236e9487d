// Compiles all inner loops and their table for the instruction set that EMTR_KERNEL names.
#include "kernels/lanes.h"
//
#include "kernels/consensus.inl"
#include "kernels/descriptors.inl"
#include "kernels/matching.inl"
//
#include "kernels/block_matching.inl"
#include "kernels/nearest.inl"
#include "kernels/sums.inl"
#include "kernels/voxels.inl"
//
#include "kernels/consistency.inl"

namespace emtr::EMTR_KERNEL {

constexpr Kernels all(const char* name) {
  Kernels k = {};
  k.name = name;
  k.transform = transform;
  k.squared_distances = squared_distances;
  k.nearest = nearest;
  k.voxel_squared_distances = voxel_squared_distances;
  k.voxel_nearest = voxel_nearest;
  k.rho_sum = rho_sum;
  k.consensus = consensus;
  k.consistent = consistent;
  k.count_common = count_common;
  k.moments = moments;
  k.plane_normals = plane_normals;
  k.pair_histograms = pair_histograms;
  k.weighted_histograms = weighted_histograms;
  k.minimum_squared_distance = minimum_squared_distance;
  k.nearest_descriptors = nearest_descriptors;
  k.nearest_in_blocks = nearest_in_blocks;
  return k;
}

}  // namespace emtr::EMTR_KERNEL
