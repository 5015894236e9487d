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
#include "kernels/bins.inl"
#include "kernels/consistency.inl"
#include "kernels/pairs.inl"
#include "kernels/reach.inl"
#include "kernels/sampling.inl"
#include "kernels/seed_steps.inl"
#include "kernels/votes.inl"

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

constexpr SearchKernels search() {
  SearchKernels k = {};
  k.reach_bounds = reach_bounds;
  k.count_candidates = count_candidates;
  k.list_candidates = list_candidates;
  k.pose_inliers = pose_inliers;
  k.sampling_sums = sampling_sums;
  k.add_rho = add_rho;
  k.plane_to_plane = plane_to_plane;
  k.direction_bins = direction_bins;
  k.vote = vote;
  return k;
}

}  // namespace emtr::EMTR_KERNEL
