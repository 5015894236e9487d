#include "read/vector_field.h"

#include <pcl/common/io.h>

#include <cstring>
#include <vector>

#include "failure.h"
#include "text/words.h"

namespace cli {
namespace {

bool floating(const pcl::PCLPointField& field) {
  return field.count <= 1 && (field.datatype == pcl::PCLPointField::FLOAT32 ||
                              field.datatype == pcl::PCLPointField::FLOAT64);
}

}  // namespace

Eigen::Vector3d VectorField::get(const std::uint8_t* point) const {
  Eigen::Vector3d value;
  for (int i = 0; i < 3; ++i) {
    if (single) {
      float v;
      std::memcpy(&v, point + offset[i], sizeof v);
      value[i] = v;
    } else {
      std::memcpy(&value[i], point + offset[i], sizeof(double));
    }
  }
  return value;
}

void VectorField::set(std::uint8_t* point, const Eigen::Vector3d& value) const {
  for (int i = 0; i < 3; ++i) {
    const float v = static_cast<float>(value[i]);
    if (single)
      std::memcpy(point + offset[i], &v, sizeof v);
    else
      std::memcpy(point + offset[i], &value[i], sizeof(double));
  }
}

bool VectorField::contiguous() const {
  const std::size_t width = single ? sizeof(float) : sizeof(double);
  return offset[1] == offset[0] + width && offset[2] == offset[1] + width;
}

bool find_vector(const pcl::PCLPointCloud2& blob, const std::string (&names)[3],
                 VectorField& field) {
  std::uint8_t datatype = 0;
  for (int i = 0; i < 3; ++i) {
    const int index = pcl::getFieldIndex(blob, names[i]);
    if (index < 0) return false;
    const auto& found = blob.fields[static_cast<std::size_t>(index)];
    if (!floating(found) || (i > 0 && found.datatype != datatype)) return false;
    datatype = found.datatype;
    field.offset[i] = found.offset;
  }
  field.single = datatype == pcl::PCLPointField::FLOAT32;
  return true;
}

VectorField require_vector(const CloudFile& cloud, const std::string (&names)[3],
                           const std::string& purpose) {
  VectorField field{};
  if (find_vector(cloud.blob, names, field)) return field;
  for (const auto& name : names)
    if (pcl::getFieldIndex(cloud.blob, name) < 0) refuse_missing_field(cloud, name, purpose);
  std::string what = "expected fields ";
  what.append(joined({names[0], names[1], names[2]}, " and "));
  throw FileFailure(cloud.path, what.append(" to be all float or all double").append(purpose));
}

void refuse_missing_field(const CloudFile& cloud, const std::string& name,
                          const std::string& purpose) {
  std::vector<std::string> names;
  for (const auto& field : cloud.blob.fields) names.push_back(field.name);
  std::string what = "has no field '";
  what.append(name).append("'").append(purpose).append(", only ").append(joined(names));
  throw FileFailure(cloud.path, what);
}

}  // namespace cli
