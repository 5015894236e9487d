#pragma once

#include <istream>
#include <string>

namespace cli {

/// Throws FileFailure unless the stream can be written to, as far as that is known without opening
/// it: to open a pipe would wait for its reader, and to close it would end him.
void require_writable_stream(const std::string& path);

/// Writes all that `in` has to the stream; waits for the reader of a pipe. What the stream has
/// already stays. Throws Failure, also when a signal ends the wait.
void write_stream(const std::string& path, std::istream& in);

}  // namespace cli
