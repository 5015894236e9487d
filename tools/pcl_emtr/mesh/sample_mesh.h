#pragma once

#include <cstddef>

#include "read/cloud_file.h"

namespace cli {

/// Replaces the vertices of a mesh by points that sample its surface evenly, with a note; the
/// vertices stay in `cloud.vertices`. With 0 points the vertices remain the points. A file whose
/// faces are no surface, because most of its vertices are in no face or because the faces have no
/// area, is a cloud: its faces are dropped, with a note.
void sample_mesh(CloudFile& cloud, std::size_t points);

/// Makes the vertices the points again, as the file has them; the samples are gone.
void take_vertices(CloudFile& cloud);

}  // namespace cli
