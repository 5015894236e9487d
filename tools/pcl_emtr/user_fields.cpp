#include "user_fields.h"

#include <pcl/common/io.h>

#include "coordinates.h"
#include "failure.h"
#include "setting_text.h"

namespace cli {
namespace {

const std::string kNormals[3] = {"normal_x", "normal_y", "normal_z"};

std::string field_names(const CloudFile& cloud) {
  std::string names;
  for (const auto& field : cloud.blob.fields) names += (names.empty() ? "" : ", ") + field.name;
  return names;
}

void set_user_normals(const CloudFile& cloud, emtr_cloud& view, std::vector<double>& copy) {
  VectorField field{};
  if (!find_vector(cloud.blob, kNormals, field)) {
    for (const auto& name : kNormals)
      if (pcl::getFieldIndex(cloud.blob, name) < 0)
        throw FileFailure(cloud.path, "has no field '" + name + "' for --use-normals, only " +
                                          field_names(cloud));
    throw FileFailure(cloud.path,
                      "expected fields normal_x, normal_y and normal_z to be all float or all "
                      "double");
  }
  const std::uint8_t* data = cloud.blob.data.data();
  const std::size_t stride = cloud.blob.point_step;
  const std::size_t width = field.single ? sizeof(float) : sizeof(double);
  const bool side_by_side =
      field.offset[1] == field.offset[0] + width && field.offset[2] == field.offset[1] + width;
  if (side_by_side && field.single == (view.scalar == EMTR_FLOAT32)) {
    view.normals = data + field.offset[0];
    view.normal_stride = stride;
    return;
  }
  const bool single = view.scalar == EMTR_FLOAT32;
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

void set_user_features(const CloudFile& cloud, const std::string& name, emtr_cloud& view) {
  const int index = pcl::getFieldIndex(cloud.blob, name);
  if (index < 0)
    throw FileFailure(cloud.path,
                      "has no field '" + name + "' for --use-features, only " + field_names(cloud));
  const auto& field = cloud.blob.fields[static_cast<std::size_t>(index)];
  if (field.datatype != pcl::PCLPointField::FLOAT32)
    throw FileFailure(cloud.path, "expected field '" + name + "' to be of floats");
  view.features = reinterpret_cast<const float*>(cloud.blob.data.data() + field.offset);
  view.feature_dimension = field.count ? field.count : 1;
  view.feature_stride = cloud.blob.point_step;
}

}  // namespace

void UserFields::add_options(CLI::App& app) {
  app.add_flag("--use-normals", normals,
               wrapped("use the fields normal_x, normal_y, normal_z of both files instead of "
                       "estimating normals, as pcl_normal_estimation writes them",
                       66));
  app.add_flag("--use-features{fpfh}", features,
               wrapped("match the points by this field of both files, floats of any number, "
                       "instead of by features of our own; fpfh, as pcl_fpfh_estimation writes it, "
                       "unless another is named: --use-features=shot",
                       66));
}

void UserFields::set_user_input(const CloudFile& cloud, emtr_cloud& view,
                           std::vector<double>& copy) const {
  if (normals) set_user_normals(cloud, view, copy);
  if (!features.empty()) set_user_features(cloud, features, view);
}

}  // namespace cli
