#include <emtr/emtr.h>

#include <algorithm>
#include <memory>

#include "arguments.h"
#include "guarded.h"
#include "handles.h"

using emtr::guarded;
using emtr::required;

extern "C" {

emtr_status emtr_prepare(const emtr_cloud* cloud, const char* name, int32_t threads,
                         emtr_prepared** prepared) {
  return guarded([&] {
    required(prepared, "prepared") = nullptr;
    *prepared = new emtr_prepared{std::make_shared<const emtr::PreparedCloud>(
        required(cloud, "cloud"), name ? name : "", emtr::given_threads(threads))};
  });
}

void emtr_prepared_free(emtr_prepared* prepared) { delete prepared; }

emtr_status emtr_prepared_describe(const emtr_prepared* prepared, emtr_prepared_info* info,
                                   size_t size) {
  return guarded([&] {
    const emtr::PreparedCloud& cloud = *required(prepared, "prepared").cloud;
    emtr_prepared_info out{};
    out.points = cloud.count;
    out.dropped = cloud.dropped;
    out.kept = cloud.base.size();
    std::copy_n(cloud.center, 3, out.center);
    out.radius = cloud.radius;
    out.normals = cloud.normals.size() != 0;
    out.described = cloud.described.rows.size();
    out.feature_dimension = cloud.described.dimension;
    emtr::hand_out(out, info, size);
  });
}

}  // extern "C"
