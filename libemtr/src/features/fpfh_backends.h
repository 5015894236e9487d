#pragma once

#include "fpfh.h"

namespace emtr {

Features describe_by_pcl(const Cloud& cloud, const FeatureDefinition& definition, int threads);
Features describe_by_kernels(const Cloud& cloud, const FeatureDefinition& definition,
                             const Kernels& kernels, int threads);

}  // namespace emtr
