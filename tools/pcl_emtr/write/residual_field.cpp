#include "write/residual_field.h"

#include <pcl/common/io.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>

#include "failure.h"

namespace cli {
namespace {

const std::string kField = "residual";

/// Adds room for one float at the end of each point; returns its offset.
std::size_t appended_field(pcl::PCLPointCloud2& blob) {
  const std::size_t points = std::size_t{blob.width} * blob.height, before = blob.point_step,
                    after = before + sizeof(float);
  std::vector<std::uint8_t> data(points * after);
  for (std::size_t i = 0; i < points; ++i)
    std::copy_n(blob.data.data() + i * before, before, data.data() + i * after);
  blob.data = std::move(data);
  pcl::PCLPointField field;
  field.name = kField;
  field.offset = static_cast<std::uint32_t>(before);
  field.datatype = pcl::PCLPointField::FLOAT32;
  field.count = 1;
  blob.fields.push_back(field);
  blob.point_step = static_cast<std::uint32_t>(after);
  blob.row_step = blob.point_step * blob.width;
  return before;
}

}  // namespace

void require_place_for_residuals(const CloudFile& cloud, const Format& format) {
  if (format.extension == std::string(".obj"))
    throw UsageFailure("--residuals: OBJ cannot hold field 'residual', write a .ply or .pcd file");
  for (const auto& field : cloud.file_fields())
    if (field.name == kField && (field.datatype != pcl::PCLPointField::FLOAT32 || field.count > 1))
      throw FileFailure(cloud.path,
                        "--residuals writes field 'residual', but the file has one already that is "
                        "not a single float");
}

void set_residuals(CloudFile& cloud, const std::vector<double>& residuals) {
  const int index = pcl::getFieldIndex(cloud.blob, kField);
  const std::size_t offset = index < 0 ? appended_field(cloud.blob)
                                       : cloud.blob.fields[static_cast<std::size_t>(index)].offset;
  std::uint8_t* place = cloud.blob.data.data() + offset;
  for (const double residual : residuals) {
    const auto value = static_cast<float>(residual);
    std::memcpy(place, &value, sizeof value);
    place += cloud.blob.point_step;
  }
}

}  // namespace cli
