#pragma once

#include "geometry/cloud.h"

namespace emtr {

/// Returns the share of the points that lie with their twelve nearest on a sheet or a line, and not
/// in a volume: near 1 for a scan of surfaces, near 0 for points scattered in space. Looks at a
/// hundred points, among 20 000 of the cloud and among fewer, where the noise of a dense scan is
/// less than the distance of neighbors; the largest of these shares is the cloud's.
double flat_share(const Cloud& cloud);

}  // namespace emtr
