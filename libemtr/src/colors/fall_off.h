#pragma once

#include "geometry/surface.h"

namespace emtr {

/// Returns the logarithms of a surface's intensities, the first channel of what ColorReader reads,
/// without the fall-off with range and the angle of incidence: less a polynomial of fourth degree
/// in the coordinates, and then less a plane over the neighborhood of each point. What is left of
/// the fall-off would draw the places below both sensors onto each other.
Cloud without_fall_off(const Surface& surface, const Cloud& intensities);

}  // namespace emtr
