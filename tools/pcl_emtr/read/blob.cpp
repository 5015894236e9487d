#include "read/blob.h"

#include <pcl/common/io.h>

#include <cstddef>
#include <cstdint>

#include "failure.h"

namespace cli {

void add_field(pcl::PCLPointCloud2& blob, const std::string& name, std::uint8_t type) {
  pcl::PCLPointField field;
  field.name = name;
  field.offset = blob.point_step;
  field.datatype = type;
  field.count = 1;
  blob.fields.push_back(field);
  blob.point_step += static_cast<std::uint32_t>(pcl::getFieldSize(type));
}

pcl::PCLPointCloud2 doubles_blob(const std::vector<std::string>& names) {
  pcl::PCLPointCloud2 blob;
  for (const std::string& name : names) add_field(blob, name, pcl::PCLPointField::FLOAT64);
  return blob;
}

void reserve_points(pcl::PCLPointCloud2& blob, std::size_t points) {
  blob.data.reserve(points * blob.point_step);
}

void add_point(pcl::PCLPointCloud2& blob, const double* values) {
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(values);
  blob.data.insert(blob.data.end(), bytes, bytes + blob.point_step);
}

void finish_blob(pcl::PCLPointCloud2& blob, const std::string& path, const std::string& expected) {
  const std::size_t points = blob.data.size() / blob.point_step;
  if (points == 0) throw FileFailure(path, "holds no points, expected " + expected);
  if (points > 0xffffffffu) throw FileFailure(path, "holds more points than PCL can");
  blob.width = static_cast<std::uint32_t>(points);
  blob.height = 1;
  blob.row_step = blob.point_step * blob.width;
  blob.is_dense = false;  // nobody has looked for NaN
}

}  // namespace cli
