#pragma once

#include <string>

#include "mesh/faces.h"

namespace cli {

/// Writes the little-endian PLY file at `vertices`, which PCL has written, to `path`, with these
/// faces between its vertices and the `behind` bytes that follow them: PCL writes no faces with the
/// fields of a cloud, and declares none. Returns false unless every byte arrived.
bool add_ply_faces(const std::string& vertices, const Faces& faces, std::size_t behind,
                   const std::string& path);

}  // namespace cli
