#pragma once

#include <array>
#include <vector>

#include "colors/channels.h"
#include "geometry/surface.h"

namespace emtr {

/// The colors of a surface as functions on its tangent planes: of each point the value there, and
/// the gradient of each channel in the plane.
struct ColorField {
  Cloud values;  ///< NaN where too few points are near
  std::array<std::vector<std::array<float, 3>>, 3> gradients;  ///< [channel][point]; empty in one
                                                               ///< that is not used
};

/// Fits a plane to each channel over the points within `radius` of each point, by least squares in
/// its tangent plane (Park, Zhou and Koltun, ICCV 2017). With `gradients` false, the values alone.
ColorField fit_color_field(const Surface& surface, const Cloud& colors, const bool used[3],
                           double radius, bool gradients);

}  // namespace emtr
