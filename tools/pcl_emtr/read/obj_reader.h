#pragma once

#include "read/cloud_file.h"

namespace cli {

/// Reads the vertices of an OBJ file as double x, y, z, and its faces. Reads its normals also when
/// there is one for each vertex: the i-th belongs to the i-th vertex, whatever the faces say. PCL's
/// own reader crashes on a line of blanks, such as the empty lines of a file from Windows. Notes
/// what was left out of the file; throws FileFailure.
void read_obj(CloudFile& cloud);

}  // namespace cli
