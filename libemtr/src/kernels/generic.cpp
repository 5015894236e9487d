#define EMTR_KERNEL generic
#include "descriptors.inl"
#include "lanes.h"
#include "matching.inl"
#include "nearest.inl"
#include "sums.inl"

namespace emtr {
extern const Kernels k_generic;
const Kernels k_generic = {"generic",
                           generic::transform,
                           generic::squared_distances,
                           generic::nearest,
                           generic::rho_sum,
                           generic::consensus,
                           generic::moments,
                           generic::least_directions,
                           generic::pair_histograms,
                           generic::weighted_histograms,
                           generic::least_squared,
                           generic::nearest_descriptors};
}  // namespace emtr
