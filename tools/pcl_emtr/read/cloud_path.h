#pragma once

#include <string>

namespace cli {

/// Returns the text with the letters A to Z in lower case.
std::string lower_case(std::string text);

/// Tells whether the path ends in ".gz".
bool is_compressed(const std::string& path);

/// Returns the extension in lower case, ".gz" apart: ".pcd" for "a/B.PCD.gz", "" when there is
/// none.
std::string extension_of(const std::string& path);

/// Says of a path why its extension is none of a cloud: "has no extension", to begin a sentence.
std::string wrong_extension(const std::string& path);

/// Throws FileFailure unless the path is a stream, or a readable regular file of a known format.
/// `format` is the format that the user named, or empty.
void require_cloud_file(const std::string& path, const std::string& format = "");

}  // namespace cli
