#include "read/ply_camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <fstream>
#include <map>

#include "read/ply_header.h"
#include "text/numbers.h"
#include "text/words.h"

namespace cli {
namespace {

using Values = std::map<std::string, double>;

Values read_text(std::istream& in, const PlyElement& camera) {
  Values values;
  std::string line;
  while (std::getline(in, line) && words_of(line).empty()) {
  }
  const auto words = words_of(line);
  for (std::size_t i = 0; i < std::min(words.size(), camera.properties.size()); ++i)
    values[camera.properties[i].name] = parse_real(words[i]).value_or(NAN);
  return values;
}

Values read_binary(std::istream& in, const PlyElement& camera, bool big_endian) {
  Values values;
  for (const auto& property : camera.properties) {
    std::array<char, 8> bytes{};
    in.read(bytes.data(), static_cast<std::streamsize>(property.bytes));
    if (big_endian) std::reverse(bytes.data(), bytes.data() + property.bytes);
    if (!property.is_real()) continue;
    if (property.bytes == 4) {
      float value;
      std::memcpy(&value, bytes.data(), sizeof value);
      values[property.name] = value;
    } else {
      double value;
      std::memcpy(&value, bytes.data(), sizeof value);
      values[property.name] = value;
    }
  }
  return in ? values : Values{};
}

/// Moves `in` past one element; returns false when that takes reading its lists.
bool skip(std::istream& in, const PlyElement& element, bool text) {
  if (!text && element.has_list() && element.count > 0) return false;
  if (!text) {
    in.seekg(static_cast<std::streamoff>(element.count * element.least_bytes()), std::ios::cur);
    return true;
  }
  std::string line;
  for (std::uint64_t row = 0; row < element.count && std::getline(in, line);)
    if (!words_of(line).empty()) ++row;
  return true;
}

}  // namespace

void read_ply_camera(CloudFile& cloud) {
  std::ifstream in(cloud.place, std::ios::binary);
  const PlyHeader header = read_ply_header(in, cloud.path);
  const PlyElement* camera = header.find("camera");
  if (!camera || camera->count != 1 || camera->has_list()) return;
  const bool text = header.format == PlyHeader::Ascii;
  for (const auto& element : header.elements) {
    if (&element == camera) break;
    if (!skip(in, element, text)) return;
  }
  Values values = text ? read_text(in, *camera)
                       : read_binary(in, *camera, header.format == PlyHeader::BigEndian);

  static const std::array<std::string, 3> xyz = {"x", "y", "z"};
  Eigen::Vector3d origin;
  Eigen::Matrix3d rotation;
  for (int i = 0; i < 3; ++i) {
    const auto& axis = xyz[static_cast<std::size_t>(i)];
    if (!values.count("view_p" + axis)) return;
    origin[i] = values["view_p" + axis];
    for (int j = 0; j < 3; ++j) {
      const std::string name = axis + "_axis" + xyz[static_cast<std::size_t>(j)];
      if (!values.count(name)) return;
      rotation(i, j) = values[name];
    }
  }
  if (!origin.allFinite() || !rotation.isUnitary(1e-3)) return;
  cloud.sensor_origin = origin;
  cloud.sensor_orientation = Eigen::Quaterniond(rotation);
}

}  // namespace cli
