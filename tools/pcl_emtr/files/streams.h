#pragma once

#include <optional>
#include <string>

namespace cli {

/// Returns the open file that a path such as /dev/stdout or /dev/fd/63 means, also through links.
/// Where the shell has sent that file to is not followed.
std::optional<int> descriptor_of(const std::string& path);

/// Tells whether the path is read and written as a stream: an open file of this process, or
/// anything that exists and is not a regular file, such as a named pipe or /dev/null.
bool is_stream(const std::string& path);

/// Returns a name that two paths share when they are one open file or one pipe, or "" for a stream
/// of which any number of files may be made, such as /dev/null.
std::string stream_name(const std::string& path);

}  // namespace cli
