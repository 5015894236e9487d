#pragma once

#include "features/fpfh.h"

namespace emtr {

/// Both take `normals` as describe() does, already oriented.
Features describe_by_pcl(const Cloud& cloud, const FeatureDefinition& definition, int threads,
                         const Cloud& normals);
Features describe_by_kernels(const Cloud& cloud, const FeatureDefinition& definition,
                             const Kernels& kernels, int threads, const Cloud& normals);

}  // namespace emtr
