#include "coordinates.h"

#include <pcl/common/io.h>

#include <cstring>

#include "failure.h"

namespace cli {
namespace {

const std::string kCoordinates[3] = {"x", "y", "z"};

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

void require_coordinates(const CloudFile& cloud) {
  VectorField field{};
  if (find_vector(cloud.blob, kCoordinates, field)) return;
  std::string names;
  for (const auto& found : cloud.blob.fields) {
    if (!names.empty()) names += ", ";
    names += found.name;
  }
  for (const auto& name : kCoordinates)
    if (pcl::getFieldIndex(cloud.blob, name) < 0) {
      std::string what = "has no field '";
      throw FileFailure(cloud.path, what.append(name).append("', only ").append(names));
    }
  throw FileFailure(cloud.path, "expected fields x, y and z to be all float or all double");
}

emtr_cloud coordinates(const CloudFile& cloud, std::vector<double>& copy) {
  VectorField field{};
  find_vector(cloud.blob, kCoordinates, field);
  const std::size_t stride = cloud.blob.point_step;
  const std::uint8_t* data = cloud.blob.data.data();
  const std::size_t width = field.single ? sizeof(float) : sizeof(double);
  if (field.offset[1] == field.offset[0] + width && field.offset[2] == field.offset[1] + width)
    return {data + field.offset[0], cloud.size(), stride,
            field.single ? EMTR_FLOAT32 : EMTR_FLOAT64};

  copy.resize(3 * cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i)
    Eigen::Vector3d::Map(&copy[3 * i]) = field.get(data + i * stride);
  return {copy.data(), cloud.size(), 0, EMTR_FLOAT64};
}

}  // namespace cli
