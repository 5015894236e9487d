#pragma once

#include "read/cloud_file.h"

namespace cli {

/// Reads a text table with a line for each point: x, y, z and perhaps more, parted by blanks, tabs,
/// commas or semicolons. Skips empty lines and comments. A header line, which may be a comment,
/// names the columns; named ones become fields of doubles. A line of one whole number, first of all
/// or between points, is the number of points that follow, as in .pts. An empty cell is a NaN.
/// Throws FileFailure that names the line.
void read_text(CloudFile& cloud);

}  // namespace cli
