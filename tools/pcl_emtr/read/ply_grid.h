#pragma once

#include <cstdint>
#include <istream>
#include <string>

#include "read/ply_header.h"

namespace cli {

/// Throws FileFailure when a PLY file lays out its vertices in a grid that does not fit their
/// number. PCL believes each word of `obj_info num_cols` and `num_rows` and each index of the
/// element range_grid, and reads or writes where they point. `in` stands behind the header and is
/// left there.
void check_grid(std::istream& in, const PlyHeader& header, const std::string& path,
                std::uint64_t vertices);

}  // namespace cli
