#pragma once

#include <emtr/emtr.h>

#include <Eigen/Core>
#include <string>
#include <vector>

#include "cloud_file.h"

namespace cli {

/// Three fields of one floating type that together are one vector of each point.
struct VectorField {
  std::size_t offset[3];
  bool single;  // float, else double

  Eigen::Vector3d get(const std::uint8_t* point) const;
  void set(std::uint8_t* point, const Eigen::Vector3d& value) const;
};

/// False when the cloud lacks one of the fields, or they are not all float or all double.
bool find_vector(const pcl::PCLPointCloud2& blob, const std::string (&names)[3],
                 VectorField& field);

/// Throws FileFailure unless x, y and z are there as float or double.
void require_coordinates(const CloudFile& cloud);

/// The coordinates as the C API takes them: where they lie in the blob if side by side, else
/// copied to `copy`. Valid as long as both live.
emtr_cloud coordinates(const CloudFile& cloud, std::vector<double>& copy);

}  // namespace cli
