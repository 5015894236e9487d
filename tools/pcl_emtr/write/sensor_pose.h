#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "read/cloud_file.h"

namespace cli {

// Returns the sensor's pose in the types that PCL's writers take.

inline Eigen::Vector4f origin_of(const CloudFile& cloud) {
  Eigen::Vector4f origin = Eigen::Vector4f::Zero();
  origin.head<3>() = cloud.sensor_origin.cast<float>();
  return origin;
}

inline Eigen::Quaternionf orientation_of(const CloudFile& cloud) {
  return cloud.sensor_orientation.cast<float>();
}

}  // namespace cli
