#pragma once

#include <cstddef>

#include "geometry/rigid.h"

namespace emtr {

/// Weighted sums over pairs of points, of which the best rigid motion follows.
class Procrustes {
 public:
  void add(const double p[3], const double q[3], double weight = 1);

  double weight() const { return weight_; }

  /// The pose with the least weighted sum of |q - (R p + t)|^2 (Kabsch 1976, Umeyama 1991). Of
  /// pairs on one line, or fewer than three, any of the best ones.
  Rigid pose() const;

 private:
  double weight_ = 0, p_[3] = {}, q_[3] = {}, pq_[9] = {};
};

}  // namespace emtr
