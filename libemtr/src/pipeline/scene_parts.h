#pragma once

#include <vector>

#include "geometry/rigid.h"
#include "pipeline/input_cloud.h"
#include "settings/settings.h"

namespace emtr {

/// A part of a large cloud, and where a small one may lie in it.
struct ScenePart {
  std::vector<double> points;  ///< (n, 3), the user's unit
  std::vector<Rigid> poses;    ///< small into large, the user's unit; not empty
};

/// Returns the parts of the large cloud where find_places() sees the small one, the most
/// likely first. A part is a ball somewhat larger than the small cloud. Both clouds are
/// preprocessed; the large one is read again where it has more points than were kept.
std::vector<ScenePart> find_scene_parts(const InputCloud& small, const InputCloud& large,
                                        const Settings& settings);

}  // namespace emtr
