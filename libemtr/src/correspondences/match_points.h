#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <vector>

#include "geometry/cloud.h"

namespace emtr {

/// Both ends of some matches, in the normalized frame: the i-th leads from p[i] to q[i].
struct MatchPoints {
  Cloud p, q;

  std::size_t size() const { return p.size(); }

  template <class Row>
  MatchPoints select(const std::vector<Row>& rows) const {
    return {p.select(rows), q.select(rows)};
  }
};

inline Eigen::Vector3d point_of(const Cloud& cloud, std::size_t i) {
  return {double{cloud.x[i]}, double{cloud.y[i]}, double{cloud.z[i]}};
}

inline double distance(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const Eigen::Vector3d d = a - b;
  return std::sqrt((d.x() * d.x() + d.y() * d.y()) + d.z() * d.z());
}

}  // namespace emtr
