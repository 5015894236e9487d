#pragma once

#include <string>

#include "read/cloud_file.h"

namespace cli {

/// Throws FileFailure about `path` when OBJ cannot hold one of the fields: it has coordinates,
/// normals and colors.
void require_obj_fields(const CloudFile& cloud, const std::string& path);

/// Writes an OBJ file; returns false unless every byte arrived. A cloud that was read from an OBJ
/// file is that file line by line, with its vertices and normals moved: groups, textures and
/// materials stay. Any other one becomes its points, colors, normals and faces.
bool write_obj(const CloudFile& cloud, const std::string& path);

}  // namespace cli
