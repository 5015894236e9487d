#pragma once

#include <emtr/emtr.h>

#include <string>
#include <vector>

#include "read/cloud_file.h"

namespace cli {

/// Names the normals and features that the user takes from fields of the clouds' files, instead of
/// having them estimated.
struct UserFields {
  bool normals = false;
  std::string features;  // the field's name; empty: none

  /// Adds them to `view`, which coordinates() made of the cloud. Normals that lie apart, or whose
  /// type is not that of the points, are copied to `copy`. Throws FileFailure that names a field
  /// which is missing or is not of floats.
  void attach(const CloudFile& cloud, emtr_cloud& view, std::vector<double>& copy) const;
};

}  // namespace cli
