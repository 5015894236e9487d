#include "ranking/given_viewpoints.h"

#include "util/error.h"

namespace emtr {
namespace {

Viewpoint normalized(const double at[3], const double center[3], double scale) {
  Viewpoint out;
  for (int a = 0; a < 3; ++a) out.at[a] = (at[a] - center[a]) / scale;
  if (!is_near(out.at, 3))
    throw Error(EMTR_ERROR_SETTING, "a viewpoint lies a million radii away from its cloud");
  return out;
}

}  // namespace

GivenViewpoints::GivenViewpoints(const Settings& s, const Normalization& normalization) {
  if (!s.free_space) return;
  if (s.has_viewpoint_source)
    source = normalized(s.viewpoint_source, normalization.center_source, normalization.scale);
  if (s.has_viewpoint_target)
    target = normalized(s.viewpoint_target, normalization.center_target, normalization.scale);
}

}  // namespace emtr
