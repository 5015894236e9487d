#include "write/ply_output.h"

#include <pcl/common/io.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <set>
#include <type_traits>

#include "failure.h"
#include "files/spool.h"
#include "modules/pcl_module.h"
#include "text/words.h"
#include "write/ply_face_output.h"
#include "write/sensor_pose.h"

namespace cli {
namespace {

constexpr std::size_t kCameraBytes = 84;  // the 21 values of PCL's PLY element "camera"

/// Returns the bytes of a field in the file, where PCL writes color as single bytes.
std::size_t ply_bytes(const pcl::PCLPointField& field) {
  if (field.name == "rgb") return 3;
  if (field.name == "rgba") return 4;
  return static_cast<std::size_t>(pcl::getFieldSize(field.datatype));
}

/// Tells whether PCL's writer would write the field as a color, because its name has the letters
/// "rgb" somewhere: a float then loses a byte, and the bytes of an integer change places.
bool taken_for_color(const pcl::PCLPointField& field) {
  const auto has = [&](const char* letters) { return field.name.find(letters) != field.name.npos; };
  return (field.datatype == pcl::PCLPointField::FLOAT32 && has("rgb")) ||
         (field.datatype == pcl::PCLPointField::UINT32 && has("rgba"));
}

/// Returns a normal's name in PLY files. PCL renames normals too, but then declares each a float,
/// whatever bytes follow.
std::string ply_name(const std::string& name) {
  const bool normal = name == "normal_x" || name == "normal_y" || name == "normal_z";
  return normal ? std::string("n") + name.back() : name;
}

/// Returns the cloud with the fields as PCL's writer has to get them.
pcl::PCLPointCloud2 ply_blob(const CloudFile& cloud) {
  pcl::PCLPointCloud2 blob = cloud.blob;
  auto& fields = blob.fields;  // "_" is PCD's name for bytes that mean nothing
  fields.erase(std::remove_if(fields.begin(), fields.end(),
                              [](const pcl::PCLPointField& field) { return field.name == "_"; }),
               fields.end());
  // PCL names the color's properties by the field's name, but counts its bytes by the type.
  for (auto& field : fields) {
    field.name = ply_name(field.name);
    if (field.name == "rgb") field.datatype = pcl::PCLPointField::FLOAT32;
    if (field.name == "rgba") field.datatype = pcl::PCLPointField::UINT32;
  }
  return blob;
}

}  // namespace

void require_ply_fields(const CloudFile& cloud, const std::string& path) {
  std::set<std::string> names;
  for (const auto& field : cloud.file_fields()) {
    if (field.name == "_") continue;
    const auto refuse = [&](const std::string& lacks, const std::string& why) {
      std::string words = "PLY ";
      words.append(lacks).append(" field '").append(shown(field.name)).append("' of '");
      words.append(cloud.path).append("'").append(why).append(", write a .pcd file instead");
      throw FileFailure(path, words);
    };
    const auto type = field.datatype;
    const bool color = field.name == "rgb" || field.name == "rgba";
    if (!names.insert(ply_name(field.name)).second) refuse("cannot hold", ", which it has twice");
    if (field.count > 1) refuse("has no arrays of fixed length for", "");
    if (type < pcl::PCLPointField::INT8 || type > pcl::PCLPointField::FLOAT64)
      refuse("has no type for", " (64-bit integer or bool)");
    if (field.name == "curvature" && type != pcl::PCLPointField::FLOAT32)
      refuse("cannot hold", ", which PCL takes for a float");
    if (color && pcl::getFieldSize(type) != 4) refuse("cannot hold", ", which is not 4 bytes");
    if (!color && taken_for_color(field))
      refuse("cannot hold", ", which PCL takes for a color by its name");
  }
}

namespace {

bool write_vertices(const CloudFile& cloud, const std::string& path) {
  const pcl::PCLPointCloud2 blob = ply_blob(cloud);
  const auto origin = origin_of(cloud);
  const auto orientation = orientation_of(cloud);
  if (pcl_module().write_ply(path, blob, origin, orientation) != 0) return false;
  std::size_t row = 0;
  for (const auto& field : blob.fields) row += ply_bytes(field);
  const std::size_t header = pcl_module().ply_header(blob, origin, orientation).size();
  return std::filesystem::file_size(path) == header + row * cloud.size() + kCameraBytes;
}

}  // namespace

bool write_ply(const CloudFile& cloud, const std::string& path) {
  if (cloud.faces.empty()) return write_vertices(cloud, path);
  const Spool vertices(path);
  return write_vertices(cloud, vertices.place()) &&
         add_ply_faces(vertices.place(), cloud.faces, kCameraBytes, path);
}

}  // namespace cli
