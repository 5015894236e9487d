#pragma once

#include <Eigen/Core>

#include "read/cloud_file.h"

namespace cli {

/// Moves a cloud by a rigid transformation or a similarity of this scale, in place: its points,
/// their directions (normals, principal curvature), its viewpoints and the sensor's pose. Leaves
/// every other field as it is. Points that are not finite stay so.
void move_cloud(CloudFile& cloud, const Eigen::Matrix4d& transformation, double scale);

}  // namespace cli
