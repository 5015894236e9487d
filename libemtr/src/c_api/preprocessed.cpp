#include <emtr/emtr.h>

#include <algorithm>
#include <memory>

#include "c_api/arguments.h"
#include "c_api/guarded.h"
#include "c_api/handles.h"

using emtr::guarded;
using emtr::required;

extern "C" {

emtr_status emtr_preprocess(const emtr_cloud* cloud, const char* name, int32_t threads,
                            emtr_preprocessed** preprocessed) {
  return guarded([&] {
    required(preprocessed, "preprocessed") = nullptr;
    *preprocessed = new emtr_preprocessed{std::make_shared<const emtr::PreprocessedCloud>(
        required(cloud, "cloud"), name ? name : "", emtr::checked_threads(threads))};
  });
}

void emtr_preprocessed_free(emtr_preprocessed* preprocessed) { delete preprocessed; }

emtr_status emtr_preprocessed_describe(const emtr_preprocessed* preprocessed,
                                       emtr_preprocessed_info* info, size_t size) {
  return guarded([&] {
    const emtr::PreprocessedCloud& cloud = *required(preprocessed, "preprocessed").cloud;
    emtr_preprocessed_info out{};
    out.points = cloud.count;
    out.dropped = cloud.dropped;
    out.strays = cloud.strays;
    out.base_points = cloud.base.size();
    std::copy_n(cloud.center, 3, out.center);
    out.radius = cloud.radius;
    out.normals = cloud.normals.size() != 0;
    out.keypoints = cloud.keypoints.rows.size();
    out.feature_dimension = cloud.keypoints.dimension;
    emtr::copy_info(out, info, size);
  });
}

}  // extern "C"
