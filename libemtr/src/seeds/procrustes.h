#pragma once

#include <Eigen/Core>

#include "geometry/rigid.h"

namespace emtr {

/// Weighted sums over pairs of points, from which the best rigid motion follows.
class Procrustes {
 public:
  void add(const Eigen::Vector3d& p, const Eigen::Vector3d& q, double weight = 1);

  double weight() const { return weight_; }

  /// Returns the pose with the smallest weighted sum of |q - (R p + t)|^2 (Kabsch 1976, Umeyama
  /// 1991). Fewer than three pairs, or pairs on one line, have many such poses: it returns any.
  Rigid pose() const;

 private:
  double weight_ = 0;
  Eigen::Vector3d p_ = Eigen::Vector3d::Zero(), q_ = Eigen::Vector3d::Zero();
  Eigen::Matrix3d pq_ = Eigen::Matrix3d::Zero();
};

}  // namespace emtr
