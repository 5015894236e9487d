#pragma once

#include <emtr/emtr.h>

#include <vector>

#include "read/cloud_file.h"

namespace cli {

/// The memory of a cloud's colors and intensities, as the C API takes them.
struct ColorFields {
  std::vector<float> colors;
  std::vector<float> intensities;
};

/// Adds to `view` the colors that the file has: fields rgb or rgba of four bytes, or red, green and
/// blue (r, g and b) of any type; and its field intensity. Whole numbers, and floats where one is
/// larger than 1, count to 255, or to 65535 where one is larger. `view` lives no longer than
/// `copy`.
void attach_colors(const CloudFile& cloud, emtr_cloud& view, ColorFields& copy);

}  // namespace cli
