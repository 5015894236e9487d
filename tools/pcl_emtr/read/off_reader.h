#pragma once

#include "read/cloud_file.h"

namespace cli {

/// Reads the vertices of an ascii OFF file (also COFF, NOFF and the like) as double x, y, z, and
/// its faces. Leaves out what follows a vertex's coordinates, with a note. Throws FileFailure.
void read_off(CloudFile& cloud);

}  // namespace cli
