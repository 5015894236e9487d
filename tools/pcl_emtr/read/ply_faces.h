#pragma once

#include "read/cloud_file.h"

namespace cli {

/// Reads the corners of the element `face`, whose vertices have been read; leaves a file alone that
/// has no such element. Throws FileFailure on a corner that is no vertex.
void read_ply_faces(CloudFile& cloud);

}  // namespace cli
