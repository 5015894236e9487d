#pragma once

#include <string>

#include "read/cloud_file.h"

namespace cli {

/// A suspicion that two clouds are in different units, because one is larger by a factor between
/// two common ones. It is a hint: nothing is scaled, and a small object beside a large scene has it
/// too.
struct UnitHint {
  double ratio = 1;   ///< how many times as large the source is
  double factor = 0;  ///< the factor between units that is near it, 10 to 1000 or inverse; 0: none
  std::string text;   ///< a sentence that names the units; empty when there is none
};

/// Compares the extents of the clouds, without the outermost points along each axis.
UnitHint unit_hint(const CloudFile& source, const CloudFile& target);

}  // namespace cli
