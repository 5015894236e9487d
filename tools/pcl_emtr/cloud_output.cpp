#include "cloud_output.h"

#include <pcl/common/io.h>
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "failure.h"
#include "numbers.h"

namespace cli {
namespace {

constexpr std::size_t kCameraBytes = 84;  // the 21 values of PCL's PLY element "camera"

Eigen::Vector4f origin_of(const CloudFile& cloud) {
  Eigen::Vector4f origin = Eigen::Vector4f::Zero();
  origin.head<3>() = cloud.sensor_origin.cast<float>();
  return origin;
}

Eigen::Quaternionf orientation_of(const CloudFile& cloud) {
  return cloud.sensor_orientation.cast<float>();
}

/// PCL's own line has six digits, which moves a sensor in UTM coordinates by metres.
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

/// By hand after the header, because PCL's writer tells nothing of a full disk.
bool write_pcd(const CloudFile& cloud, const std::string& temporary) {
  std::string header =
      pcl::PCDWriter().generateHeaderBinary(cloud.blob, origin_of(cloud), orientation_of(cloud));
  const std::size_t begin = header.find("\nVIEWPOINT") + 1;  // a field's name may have it too
  header.replace(begin, header.find('\n', begin) - begin, viewpoint_line(cloud));
  std::ofstream out(temporary, std::ios::binary);
  out << header << "DATA binary\n";
  out.write(reinterpret_cast<const char*>(cloud.blob.data.data()),
            static_cast<std::streamsize>(cloud.size() * cloud.blob.point_step));
  out.close();
  return out.good();
}

/// PCL writes colour as single bytes.
std::size_t ply_bytes(const pcl::PCLPointField& field) {
  if (field.name == "rgb") return 3;
  if (field.name == "rgba") return 4;
  return static_cast<std::size_t>(pcl::getFieldSize(field.datatype));
}

/// PCL's writer does so wherever the letters stand in the name: a float loses a byte, and of an
/// integer the bytes change places.
bool taken_for_color(const pcl::PCLPointField& field) {
  const auto has = [&](const char* letters) { return field.name.find(letters) != field.name.npos; };
  return (field.datatype == pcl::PCLPointField::FLOAT32 && has("rgb")) ||
         (field.datatype == pcl::PCLPointField::UINT32 && has("rgba"));
}

/// A normal's name in PLY files. PCL gives it too, but calls what it had by another name a float,
/// whatever bytes follow.
std::string ply_name(const std::string& name) {
  const bool normal = name == "normal_x" || name == "normal_y" || name == "normal_z";
  return normal ? std::string("n") + name.back() : name;
}

bool write_ply(const CloudFile& cloud, const std::string& temporary) {
  pcl::PCLPointCloud2 blob = cloud.blob;
  auto& fields = blob.fields;  // "_" is PCD's name for bytes that mean nothing
  fields.erase(std::remove_if(fields.begin(), fields.end(),
                              [](const pcl::PCLPointField& field) { return field.name == "_"; }),
               fields.end());
  // PCL names the colour's properties by the field's name, but counts its bytes by the type.
  for (auto& field : fields) {
    field.name = ply_name(field.name);
    if (field.name == "rgb") field.datatype = pcl::PCLPointField::FLOAT32;
    if (field.name == "rgba") field.datatype = pcl::PCLPointField::UINT32;
  }
  pcl::PLYWriter writer;
  const auto origin = origin_of(cloud);
  const auto orientation = orientation_of(cloud);
  if (writer.writeBinary(temporary, blob, origin, orientation, true) != 0) return false;
  std::size_t row = 0;
  for (const auto& field : fields) row += ply_bytes(field);
  const std::size_t header =
      writer.generateHeaderBinary(blob, origin, orientation, static_cast<int>(cloud.size()), true)
          .size();
  return std::filesystem::file_size(temporary) == header + row * cloud.size() + kCameraBytes;
}

}  // namespace

void require_writable_as(const std::string& path, const CloudFile& cloud) {
  if (extension_of(path) != ".ply") return;
  std::set<std::string> names;
  for (const auto& field : cloud.blob.fields) {
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
      refuse("cannot hold", ", which PCL takes for a colour by its name");
  }
}

void write_cloud(const CloudFile& cloud, const std::string& path, const std::string& temporary) {
  const bool whole =
      extension_of(path) == ".ply" ? write_ply(cloud, temporary) : write_pcd(cloud, temporary);
  if (!whole) throw FileFailure(path, "cannot be written whole, is the disk full?");
}

}  // namespace cli
