#include "write/pcd_output.h"

#include <cstddef>
#include <fstream>
#include <sstream>

#include "modules/pcl_module.h"
#include "write/sensor_pose.h"

namespace cli {
namespace {

/// Prints the sensor's pose with nine digits. PCL's own line has six, which moves a sensor in UTM
/// coordinates by meters.
std::string viewpoint_line(const CloudFile& cloud) {
  const auto& p = cloud.sensor_origin;
  const auto& q = cloud.sensor_orientation;
  std::ostringstream line;
  line.precision(9);
  line << "VIEWPOINT";
  for (const double v : {p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z()})
    line << ' ' << static_cast<float>(v);
  return line.str();
}

}  // namespace

bool write_pcd(const CloudFile& cloud, const std::string& path) {
  std::string header = pcl_module().pcd_header(cloud.blob, origin_of(cloud), orientation_of(cloud));
  const std::size_t begin = header.find("\nVIEWPOINT") + 1;  // a field may be called VIEWPOINT too
  header.replace(begin, header.find('\n', begin) - begin, viewpoint_line(cloud));
  std::ofstream out(path, std::ios::binary);
  out << header << "DATA binary\n";
  out.write(reinterpret_cast<const char*>(cloud.blob.data.data()),
            static_cast<std::streamsize>(cloud.size() * cloud.blob.point_step));
  out.close();
  return out.good();
}

}  // namespace cli
