#pragma once

#include "clouds.h"
#include "features/fpfh.h"
#include "preprocessing/downsampling.h"
#include "preprocessing/normalization.h"
#include "real_pairs.h"
#include "settings/settings.h"

namespace emtr_test {

/// The clouds that a registration describes, and how.
struct Dense {
  emtr::Cloud source, target;
  emtr::FeatureDefinition definition;
};

template <class AnyPair>
Dense dense(const AnyPair& pair) {
  const emtr::Settings settings = emtr::preset("paper");
  const emtr::DownsampledClouds d =
      emtr::downsample(emtr::normalize(pair.source(), pair.target(), 1), settings);
  emtr::FeatureDefinition definition;
  definition.normal_radius = settings.normal_radius * d.leaf_dense;
  definition.feature_radius = settings.feature_radius * d.leaf_dense;
  return {d.source_dense, d.target_dense, definition};
}

/// One of each kind: an object, a street, a room, a CAD model.
constexpr const char* kRealPairs[] = {"stanford/bunny_000_090", "lidar/car_01_00",
                                      "threedmatch/redkitchen_1_0_3dmatch",
                                      "modelnet/bathtub_0108_crop"};

}  // namespace emtr_test
