#pragma once

#include <cstdint>
#include <istream>
#include <string>

#include "ply_header.h"

namespace cli {

/// How a PLY file lays out its vertices, held against how many there are: PCL believes each word of
/// `obj_info num_cols` and `num_rows`, and each index of the element range_grid, and reads or
/// writes where they point. `in` stands behind the header. Throws FileFailure.
void check_grid(std::istream& in, const PlyHeader& header, const std::string& path,
                std::uint64_t vertices);

}  // namespace cli
