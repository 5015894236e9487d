#pragma once

#include <Eigen/Core>

#include "cloud_file.h"

namespace cli {

/// Moves a cloud by a rigid transformation, in place: points, the directions that go with them
/// (normals, principal curvature), view points and the sensor's pose. Every other field stays.
/// Points that are not finite stay so.
void move_cloud(CloudFile& cloud, const Eigen::Matrix4d& transformation);

}  // namespace cli
