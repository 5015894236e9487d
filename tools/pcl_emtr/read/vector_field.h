#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <string>

#include "read/cloud_file.h"

namespace cli {

/// Three fields of one floating type that together are one vector of each point.
struct VectorField {
  std::size_t offset[3];
  bool single;  // float, else double

  Eigen::Vector3d get(const std::uint8_t* point) const;
  void set(std::uint8_t* point, const Eigen::Vector3d& value) const;

  /// Tells whether the three values lie one after the other, as the C API takes them.
  bool contiguous() const;
};

/// Finds the three fields; returns false when the cloud lacks one of them, or when they are neither
/// all float nor all double.
bool find_vector(const pcl::PCLPointCloud2& blob, const std::string (&names)[3],
                 VectorField& field);

/// Finds the three fields; throws FileFailure that names what is missing. `purpose` says who asks:
/// " for --use-normals".
VectorField require_vector(const CloudFile& cloud, const std::string (&names)[3],
                           const std::string& purpose = "");

/// Throws FileFailure that lists the fields which the cloud has instead of `name`.
[[noreturn]] void refuse_missing_field(const CloudFile& cloud, const std::string& name,
                                       const std::string& purpose);

}  // namespace cli
