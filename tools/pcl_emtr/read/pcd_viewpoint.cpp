#include "read/pcd_viewpoint.h"

#include <algorithm>
#include <cmath>
#include <fstream>

#include "read/pcd_header.h"

namespace cli {

void read_pcd_viewpoint(CloudFile& cloud) {
  std::ifstream in(cloud.place, std::ios::binary);
  const auto viewpoint = PcdHeader(in, cloud.path).viewpoint();
  if (!viewpoint) return;
  const auto& v = *viewpoint;
  if (std::all_of(v.begin(), v.end(), [](double value) { return std::isfinite(value); })) {
    cloud.sensor_origin = {v[0], v[1], v[2]};
    cloud.sensor_orientation = Eigen::Quaterniond(v[3], v[4], v[5], v[6]);
  } else {
    cloud.add_note("its VIEWPOINT is left out, it is not finite");
  }
}

}  // namespace cli
