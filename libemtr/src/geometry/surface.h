#pragma once

#include "geometry/cloud.h"

namespace emtr {

/// A cloud with the directions of its surface. In the normalized frame, in any order.
struct Surface {
  Cloud points;
  Cloud normals;    ///< one a point; of unit length, of any sign, NaN where there is none
  double leaf = 0;  ///< spacing of the points, above 0
};

}  // namespace emtr
