#include "write/obj_output.h"

#include <pcl/common/io.h>

#include <array>
#include <cstring>
#include <fstream>
#include <optional>

#include "failure.h"
#include "read/vector_field.h"
#include "text/numbers.h"
#include "text/words.h"

namespace cli {
namespace {

const std::array<std::string, 3> kNormals[] = {{"normal_x", "normal_y", "normal_z"},
                                               {"nx", "ny", "nz"}};

bool is_obj(const CloudFile& cloud) {
  return cloud.format && cloud.format->extension == std::string(".obj");
}

/// Nine digits tell floats apart, 17 doubles.
std::string three(const Eigen::Vector3d& v, bool single) {
  std::string text;
  for (int i = 0; i < 3; ++i)
    text += " " + (single ? exact_single(static_cast<float>(v[i])) : exact(v[i]));
  return text;
}

VectorField coordinates_of(const CloudFile& cloud) {
  return require_vector(cloud, {"x", "y", "z"});
}

std::optional<VectorField> normals_of(const CloudFile& cloud) {
  for (const auto& names : kNormals) {
    VectorField field{};
    if (find_vector(cloud.blob, {names[0], names[1], names[2]}, field)) return field;
  }
  return std::nullopt;
}

/// Returns where the color of a point lies, as PCL packs it.
std::optional<std::size_t> color_of(const CloudFile& cloud) {
  for (const char* name : {"rgb", "rgba"}) {
    const int index = pcl::getFieldIndex(cloud.blob, name);
    if (index >= 0) return cloud.blob.fields[static_cast<std::size_t>(index)].offset;
  }
  return std::nullopt;
}

std::string color_text(const std::uint8_t* packed) {
  std::uint32_t color;
  std::memcpy(&color, packed, sizeof color);
  std::string text;
  for (const unsigned bit : {16u, 8u, 0u}) text += " " + brief((color >> bit & 255u) / 255.0);
  return text;
}

void write_points(const CloudFile& cloud, std::ostream& out) {
  const VectorField place = coordinates_of(cloud);
  const auto normals = normals_of(cloud);
  const auto color = color_of(cloud);
  const std::uint8_t* point = cloud.blob.data.data();
  for (std::size_t i = 0; i < cloud.size(); ++i, point += cloud.blob.point_step) {
    out << "v" << three(place.get(point), place.single);
    out << (color ? color_text(point + *color) : "") << '\n';
    if (normals) out << "vn" << three(normals->get(point), normals->single) << '\n';
  }
  for (std::size_t face = 0; face < cloud.faces.size(); ++face) {
    out << 'f';
    for (std::size_t i = cloud.faces.begin_of(face); i < cloud.faces.ends[face]; ++i) {
      const std::string corner = std::to_string(cloud.faces.corners[i] + std::size_t{1});
      out << ' ' << corner << (normals ? "//" + corner : "");
    }
    out << '\n';
  }
}

/// Writes the lines of the OBJ file that the cloud was read from, with what has moved in its place.
void write_lines(const CloudFile& cloud, std::ostream& out) {
  std::ifstream in(cloud.place, std::ios::binary);
  const VectorField place = coordinates_of(cloud);
  std::size_t row = 0;
  std::string line;
  while (std::getline(in, line)) {
    const auto words = words_of(line);
    const bool vertex = !words.empty() && words[0] == "v" && row < cloud.size();
    const bool normal = !words.empty() && words[0] == "vn";
    if (!vertex && !normal) {
      out << line << (in.eof() ? "" : "\n");
      continue;
    }
    Eigen::Vector3d value;
    for (int i = 0; i < 3 && normal; ++i)
      value[i] = parse_real(words.at(static_cast<std::size_t>(i) + 1)).value_or(0);
    if (vertex) value = place.get(cloud.blob.data.data() + row++ * cloud.blob.point_step);
    if (normal) value = cloud.rotation * value;
    out << words[0] << three(value, false);
    for (std::size_t i = 4; i < words.size(); ++i) out << ' ' << words[i];
    out << '\n';
  }
}

}  // namespace

void require_obj_fields(const CloudFile& cloud, const std::string& path) {
  for (const auto& field : cloud.file_fields()) {
    bool known = field.name == "_" || field.name == "rgb" || field.name == "rgba";
    for (const char* axis : {"x", "y", "z"})
      known = known || field.name == axis || field.name == std::string("normal_") + axis ||
              field.name == std::string("n") + axis;
    const bool color = field.name.compare(0, 3, "rgb") == 0;
    if (!known || (color && pcl::getFieldSize(field.datatype) != 4) || field.count > 1)
      throw FileFailure(path, "OBJ cannot hold field '" + shown(field.name) + "' of '" +
                                  cloud.path + "', write a .ply or .pcd file instead");
  }
}

bool write_obj(const CloudFile& cloud, const std::string& path) {
  std::ofstream out(path, std::ios::binary);
  is_obj(cloud) ? write_lines(cloud, out) : write_points(cloud, out);
  out.close();
  return out.good();
}

}  // namespace cli
