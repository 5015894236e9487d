#pragma once

#include "read/cloud_file.h"

namespace cli {

/// Reads the triangles of an STL file, ascii or binary. STL repeats a vertex in each of its faces;
/// equal ones become one vertex. Throws FileFailure.
void read_stl(CloudFile& cloud);

}  // namespace cli
