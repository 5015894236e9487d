#pragma once

#include "read/cloud_file.h"

namespace cli {

/// Reads an array of numpy.save: (N, 3), float32 or float64, in C order. Throws FileFailure on any
/// other array.
void read_npy(CloudFile& cloud);

}  // namespace cli
