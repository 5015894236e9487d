#include "read/user_fields.h"

#include <pcl/common/io.h>

#include "failure.h"
#include "read/vector_field.h"

namespace cli {
namespace {

const std::string kNormals[3] = {"normal_x", "normal_y", "normal_z"};

void attach_normals(const CloudFile& cloud, emtr_cloud& view, std::vector<double>& copy) {
  const VectorField field = require_vector(cloud, kNormals, " for --use-normals");
  const std::uint8_t* data = cloud.blob.data.data();
  const std::size_t stride = cloud.blob.point_step;
  const bool single = view.scalar == EMTR_FLOAT32;
  if (field.contiguous() && field.single == single) {
    view.normals = data + field.offset[0];
    view.normal_stride = stride;
    return;
  }
  copy.resize(3 * cloud.size());  // floats take half of it
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3d normal = field.get(data + i * stride);
    if (single)
      Eigen::Vector3f::Map(reinterpret_cast<float*>(copy.data()) + 3 * i) = normal.cast<float>();
    else
      Eigen::Vector3d::Map(&copy[3 * i]) = normal;
  }
  view.normals = copy.data();
  view.normal_stride = 0;
}

void attach_features(const CloudFile& cloud, const std::string& name, emtr_cloud& view) {
  const int index = pcl::getFieldIndex(cloud.blob, name);
  if (index < 0) refuse_missing_field(cloud, name, " for --use-features");
  const auto& field = cloud.blob.fields[static_cast<std::size_t>(index)];
  if (field.datatype != pcl::PCLPointField::FLOAT32)
    throw FileFailure(cloud.path, "expected field '" + name + "' to be of floats");
  view.features = reinterpret_cast<const float*>(cloud.blob.data.data() + field.offset);
  view.feature_dimension = field.count ? field.count : 1;
  view.feature_stride = cloud.blob.point_step;
}

}  // namespace

void UserFields::attach(const CloudFile& cloud, emtr_cloud& view, std::vector<double>& copy) const {
  if (normals) attach_normals(cloud, view, copy);
  if (!features.empty()) attach_features(cloud, features, view);
}

}  // namespace cli
