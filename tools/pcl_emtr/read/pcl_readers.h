#pragma once

#include "read/cloud_file.h"

namespace cli {

// Read a file by PCL, after the checks of read/format_check.h; throw FileFailure. The faces of a
// PLY file come with the vertices, and PLY files of the plain binary form need no PCL.

void read_pcd(CloudFile& cloud);
void read_ply(CloudFile& cloud);

}  // namespace cli
