#pragma once

#include <string>

namespace cli {

/// Four lines of four numbers with 17 digits, as numpy.loadtxt reads them. `matrix` is row-major.
std::string matrix_text(const double (&matrix)[16]);

/// Reads such a file; lines that begin with '#' and empty lines are skipped. Throws FileFailure
/// unless there are 4 lines of 4 finite numbers. Whether it is rigid is the library's to judge.
void read_matrix(const std::string& path, double (&matrix)[16]);

}  // namespace cli
