#pragma once

#include <cstdint>
#include <memory>

#include "geometry/cloud.h"
#include "neighbors/neighbors.h"
#include "priors/prior.h"
#include "settings/settings.h"

namespace emtr {

/// Knowledge complement (Algorithm 2): finds the translation that task beta's rotation lacks. From
/// t = 0, each iteration moves the rotated sparse source by the difference between the weighted
/// centroids of its points and of their nearest target points. The weights are Tukey's, and their
/// scale d shrinks geometrically from complement_scale_start to complement_scale_end.
class KnowledgeComplement {
 public:
  /// `neighbors` finds points of the sparse target within complement_scale_start.
  KnowledgeComplement(const Cloud& source, const Cloud& target,
                      std::unique_ptr<Neighbors> neighbors, const Settings& settings,
                      const Kernels& kernels);

  /// Returns the translation for a rotation. With a prior it starts at the admissible t nearest to
  /// 0, and the result is admissible.
  Eigen::Vector3d translation(const Eigen::Matrix3d& R, const Prior* prior) const;

  /// Returns how many nearest-neighbor queries one call makes.
  std::uint64_t queries() const;

 private:
  const Cloud& source_;
  const Cloud& target_;
  std::unique_ptr<Neighbors> neighbors_;
  Settings settings_;
  const Kernels& kernels_;
};

}  // namespace emtr
