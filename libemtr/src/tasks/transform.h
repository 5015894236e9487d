#pragma once

#include "../cloud.h"
#include "../rigid.h"

namespace emtr {

/// out[i] = R p[i] + t in float; out has room for as many points.
inline void transform(const Cloud& cloud, const Rigid& pose, float* ox, float* oy, float* oz) {
  float R[9], t[3];
  for (int i = 0; i < 9; ++i) R[i] = static_cast<float>(pose.R[i]);
  for (int i = 0; i < 3; ++i) t[i] = static_cast<float>(pose.t[i]);
  const float *x = cloud.x.data(), *y = cloud.y.data(), *z = cloud.z.data();
  const std::size_t n = cloud.size();
  for (std::size_t i = 0; i < n; ++i) {
    ox[i] = ((R[0] * x[i] + R[1] * y[i]) + R[2] * z[i]) + t[0];
    oy[i] = ((R[3] * x[i] + R[4] * y[i]) + R[5] * z[i]) + t[1];
    oz[i] = ((R[6] * x[i] + R[7] * y[i]) + R[8] * z[i]) + t[2];
  }
}

}  // namespace emtr
