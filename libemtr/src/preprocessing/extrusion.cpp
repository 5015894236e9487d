#include "preprocessing/extrusion.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <utility>

#include "preprocessing/base_points.h"
#include "voxels/voxel_grid.h"

namespace emtr {
namespace {

constexpr double kFlat = 1e-3;   // radii; a tenth of the finest leaf of a surface
constexpr double kHeight = 0.4;  // radii; some ten dense leaves, more than a descriptor reaches
constexpr int kLayers = 32;      // apart by less than half a dense leaf
constexpr std::size_t kMaximumCount = (1u << 20) / kLayers;  // of an outline

/// Tells whether no point lies far from the plane through the centroid, across a unit vector.
bool is_flat(const Cloud& cloud, const Eigen::Vector3d& axis) {
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const double off =
        double{cloud.x[i]} * axis[0] + double{cloud.y[i]} * axis[1] + double{cloud.z[i]} * axis[2];
    if (std::abs(off) > kFlat) return false;
  }
  return true;
}

Cloud extruded(Cloud cloud, const Eigen::Vector3d& axis) {
  for (float leaf = kBaseLeaf; cloud.size() > kMaximumCount; leaf *= 2)
    cloud = voxel_grid(cloud, leaf);
  Cloud out;
  for (int layer = 0; layer < kLayers; ++layer) {
    const double height = kHeight * (layer / (kLayers - 1.0) - 0.5);
    for (std::size_t i = 0; i < cloud.size(); ++i)
      out.append(static_cast<float>(double{cloud.x[i]} + height * axis[0]),
                 static_cast<float>(double{cloud.y[i]} + height * axis[1]),
                 static_cast<float>(double{cloud.z[i]} + height * axis[2]));
  }
  return out;
}

}  // namespace

void extrude_flat_pair(NormalizedPair& pair, const Settings& settings) {
  if (!settings.has_axis || settings.axis_tilt > 0) return;
  if (pair.preprocessed_source->normals.size() || pair.preprocessed_target->normals.size()) return;
  const Eigen::Vector3d direction = Eigen::Vector3d::Map(settings.axis);
  const Eigen::Vector3d axis = (direction / direction.cwiseAbs().maxCoeff()).normalized();
  if (!is_flat(pair.source, axis) || !is_flat(pair.target, axis)) return;
  pair.extruded = true;
  pair.source = extruded(std::move(pair.source), axis);
  pair.target = extruded(std::move(pair.target), axis);
}

}  // namespace emtr
