#pragma once

#include "geometry/cloud.h"
#include "geometry/rigid.h"

namespace emtr {

/// Holds a rotation as the kernels read it: row-major floats.
struct RotationFloats {
  float values[9];

  explicit RotationFloats(const Eigen::Matrix3d& R) {
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) values[3 * i + j] = static_cast<float>(R(i, j));
  }
};

/// Writes R p + t of each point, in float; the three arrays have room for as many points.
inline void transform(const Kernels& kernels, const PointsView& points, const Rigid& pose, float* x,
                      float* y, float* z) {
  const RotationFloats R(pose.R);
  const Eigen::Vector3f t = pose.t.cast<float>();
  kernels.transform(points, R.values, t.data(), x, y, z);
}

inline void transform(const Kernels& kernels, const Cloud& cloud, const Rigid& pose, float* x,
                      float* y, float* z) {
  transform(kernels, cloud.view(), pose, x, y, z);
}

}  // namespace emtr
