#pragma once

#include <cstddef>
#include <vector>

#include "geometry/surface.h"

namespace emtr {

/// Returns a weight for each point of the surface, above 0: small where much of the cloud faces the
/// same way. Ground, walls and floors lie on each other in false poses too, so they prove little; a
/// pole, a tree or a corner lies on its like in few. With rho the share of the cloud's normals
/// within 20 degrees of the point's, whatever their signs, the weight is (rho + 0.02)^-1.5. It is
/// the same, to a factor, wherever and however the cloud lies. 0 where there is no normal. Of a
/// surface that is not to be weighted, all weights are 1.
std::vector<float> distinctiveness(const Surface& surface);

/// Returns the row of the first of the least weights above 0; 0 where there is none.
std::size_t least_distinctive(const std::vector<float>& weights);

}  // namespace emtr
