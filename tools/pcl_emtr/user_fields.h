#pragma once

#include <emtr/emtr.h>

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "cloud_file.h"

namespace cli {

/// What is taken from the clouds' files beside the coordinates, because the user asks for it.
struct UserFields {
  bool normals = false;
  std::string features;  // the field; empty: none

  void add_options(CLI::App& app);

  /// Lets `view`, which coordinates() made of the cloud, have them: where they lie in the blob or,
  /// where normals lie apart or are of another type than the points, copied to `copy`. Throws
  /// FileFailure naming the field that is not there or not of floats.
  void set_user_input(const CloudFile& cloud, emtr_cloud& view, std::vector<double>& copy) const;
};

}  // namespace cli
