#pragma once

#include <Eigen/Core>
#include <vector>

#include "geometry/rigid.h"
#include "refinement/hessian_spectrum.h"

namespace emtr {

/// The motions that surfaces leave unconstrained at a pose, as translations and rotations: those of
/// a plane are two translations and a rotation about its normal.
class FreeMotions {
 public:
  /// `pose`: at which the spectrum was found.
  FreeMotions(const HessianSpectrum& spectrum, const Rigid& pose);

  std::size_t translations() const { return translations_.size(); }
  std::size_t rotations() const { return rotations_.size(); }
  std::size_t size() const { return translations() + rotations(); }

  /// Returns the pose after free motions. `x`: angles in radians, one a rotation, and then
  /// coordinates of the source's centroid, one a translation, in radii of the normalized frame;
  /// not how far it moves.
  Rigid at(const Eigen::VectorXd& x) const;

  /// Returns the x of the pose itself.
  Eigen::VectorXd origin() const;

 private:
  struct Screw {
    Eigen::Vector3d rotation, translation;  ///< of the center, for one radian
  };
  Rigid pose_;
  Eigen::Vector3d center_;
  std::vector<Eigen::Vector3d> translations_;  ///< orthonormal
  std::vector<Screw> rotations_;
};

}  // namespace emtr
