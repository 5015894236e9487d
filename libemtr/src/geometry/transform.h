#pragma once

#include "geometry/cloud.h"
#include "geometry/rigid.h"

namespace emtr {

/// out[i] = R p[i] + t in float; the three arrays have room for as many points.
inline void transform(const Kernels& kernels, const Cloud& cloud, const Rigid& pose, float* x,
                      float* y, float* z) {
  float R[9], t[3];
  for (int i = 0; i < 9; ++i) R[i] = static_cast<float>(pose.R[i]);
  for (int i = 0; i < 3; ++i) t[i] = static_cast<float>(pose.t[i]);
  kernels.transform(cloud.view(), R, t, x, y, z);
}

}  // namespace emtr
