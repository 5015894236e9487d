#pragma once

#include "read/cloud_file.h"

namespace cli {

/// Reads the vertices of a PLY file that check_ply() has accepted into the fields that PCL's reader
/// would give, with a copy of whole rows. Returns false, and reads nothing, when the file is not of
/// the plain form: binary_little_endian, the vertices first, no grid, and neither diffuse colors
/// nor an intensity of bytes, which PCL converts. Throws FileFailure when its vertices cannot be
/// read whole.
bool read_ply_body(CloudFile& cloud);

}  // namespace cli
