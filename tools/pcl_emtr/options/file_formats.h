#pragma once

#include <cstddef>
#include <string>

#include "options/options.h"
#include "read/cloud_file.h"

namespace cli {

/// Throws UsageFailure unless the formats that the user named are among those that there are.
void check_formats(const Options& options);

/// Returns how many points sample a mesh; `text` is what the user gave, or empty. Correspondences,
/// normals and features belong to the vertices, so that these are the points then. Throws
/// UsageFailure.
std::size_t mesh_points(const std::string& text, const Options& options);

/// Returns the format of --aligned, or null without it: the one that the user named, else by the
/// extension, else the source's own or PCD.
const Format* aligned_format(const Options& options, const CloudFile& source);

}  // namespace cli
