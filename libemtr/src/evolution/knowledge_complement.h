#pragma once

#include <cstdint>
#include <memory>

#include "geometry/cloud.h"
#include "neighbors/neighbors.h"
#include "priors/prior.h"
#include "settings/settings.h"

namespace emtr {

/// Knowledge complement (Algorithm 2): the translation that task beta's rotation
/// lacks. From t = 0, each iteration moves the rotated sparse source by the difference of the
/// weighted centroids of its points and of their nearest target points; Tukey's weights, with a
/// scale d that shrinks geometrically from complement_scale_start to complement_scale_end.
class KnowledgeComplement {
 public:
  /// `neighbors`: of the sparse target, with radius complement_scale_start.
  KnowledgeComplement(const Cloud& source, const Cloud& target,
                      std::unique_ptr<Neighbors> neighbors, const Settings& settings,
                      const Kernels& kernels);

  /// With a prior from the admissible t nearest to 0, and to one that is admissible.
  Eigen::Vector3d translation(const Eigen::Matrix3d& R, const Prior* prior) const;

  /// Look-ups of one call.
  std::uint64_t queries() const;

 private:
  const Cloud& source_;
  const Cloud& target_;
  std::unique_ptr<Neighbors> neighbors_;
  Settings settings_;
  const Kernels& kernels_;
};

}  // namespace emtr
