#pragma once

namespace emtr {

/// Returns the index of a coordinate's voxel along one axis, as pcl::VoxelGrid bins. It equals
/// std::floor(v * inverse_leaf), which is a function call for each point where the compiler may not
/// assume SSE4.1. The coordinate must be finite and its index must fit into an int.
inline int voxel_index(float v, float inverse_leaf) {
  const float voxels = v * inverse_leaf;
  const int truncated = static_cast<int>(voxels);
  return truncated - (static_cast<float>(truncated) > voxels);
}

}  // namespace emtr
