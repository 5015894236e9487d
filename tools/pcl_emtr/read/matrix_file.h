#pragma once

#include <string>

namespace cli {

/// Reads four lines of four numbers into a row-major matrix; skips empty lines and lines that begin
/// with '#'. Throws FileFailure unless there are 4 lines of 4 finite numbers. The library checks
/// that the matrix is rigid.
void read_matrix(const std::string& path, double (&matrix)[16]);

}  // namespace cli
