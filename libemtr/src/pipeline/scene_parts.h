#pragma once

#include <vector>

#include "geometry/cloud.h"
#include "geometry/rigid.h"
#include "pipeline/input_cloud.h"
#include "settings/settings.h"

namespace emtr {

/// A part of a large cloud, and where a small one may lie in it.
struct ScenePart {
  std::vector<double> points;  ///< (n, 3), the user's unit
  std::vector<Rigid> poses;    ///< small into large, the user's unit; not empty
};

/// A small and a large cloud, and the parts of the large one: balls somewhat larger than the small
/// cloud. Both clouds are preprocessed and must outlive it.
class Scene {
 public:
  /// Reads the large cloud again where it has more points than were kept.
  Scene(const InputCloud& small, const InputCloud& large);

  /// Returns the part about a pose of the small cloud, user's unit.
  ScenePart part_at(const Rigid& pose) const;

  /// Returns the parts where find_places() sees the small cloud, the most likely first.
  std::vector<ScenePart> find_parts(const Settings& settings) const;

 private:
  void append(const double* p);
  double small_radius() const;
  Rigid to_user(const Rigid& pose) const;
  std::vector<double> points_about(const Eigen::Vector3d& center) const;

  const PreprocessedCloud &preprocessed_small_, &preprocessed_large_;
  Cloud small_, large_;  ///< normalized by the large one
};

}  // namespace emtr
