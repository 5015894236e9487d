#include "write/moved_cloud.h"

#include <string>

#include "read/vector_field.h"

namespace cli {
namespace {

/// Fields by PCL's names, and nx, ny, nz, which other programs write into PCD files.
struct Vector {
  std::string names[3];
  bool point;  // else a direction, which is rotated only
};

const Vector kVectors[] = {
    {{"x", "y", "z"}, true},
    {{"vp_x", "vp_y", "vp_z"}, true},
    {{"normal_x", "normal_y", "normal_z"}, false},
    {{"nx", "ny", "nz"}, false},
    {{"principal_curvature_x", "principal_curvature_y", "principal_curvature_z"}, false},
};

}  // namespace

void move_cloud(CloudFile& cloud, const Eigen::Matrix4d& transformation, double scale) {
  const Eigen::Matrix3d linear = transformation.topLeftCorner<3, 3>();
  const Eigen::Matrix3d rotation = linear / scale;
  const Eigen::Vector3d translation = transformation.topRightCorner<3, 1>();
  for (const auto& vector : kVectors) {
    VectorField field{};
    if (!find_vector(cloud.blob, vector.names, field)) continue;
    const Eigen::Matrix3d& matrix = vector.point ? linear : rotation;
    const Eigen::Vector3d offset = vector.point ? translation : Eigen::Vector3d::Zero();
    std::uint8_t* point = cloud.blob.data.data();
    for (std::size_t i = 0; i < cloud.size(); ++i, point += cloud.blob.point_step)
      field.set(point, matrix * field.get(point) + offset);
  }
  cloud.rotation = rotation * cloud.rotation;
  // A default pose that is moved would look like one that somebody has measured.
  if (!cloud.sensor_known) return;
  cloud.sensor_origin = linear * cloud.sensor_origin + translation;
  cloud.sensor_orientation = Eigen::Quaterniond(rotation) * cloud.sensor_orientation;
}

}  // namespace cli
