#include "read/obj_reader.h"

#include <cstdint>
#include <cstring>
#include <fstream>
#include <vector>

#include "failure.h"
#include "text/numbers.h"
#include "text/words.h"

namespace cli {
namespace {

/// Reads the first three numbers behind the keyword; a color may follow them.
void read_three(const std::vector<std::string_view>& words, const std::string& path,
                std::uint64_t line, std::vector<float>& values) {
  if (words.size() < 4)
    throw FileFailure(path, "line " + std::to_string(line) + " has " +
                                std::to_string(words.size() - 1) +
                                " coordinates, expected at least 3");
  for (std::size_t i = 1; i < words.size(); ++i) {
    const auto value = parse_real(words[i]);
    if (!value)
      throw FileFailure(
          path, "line " + std::to_string(line) + ": '" + shown(words[i]) + "' is not a number");
    if (i < 4) values.push_back(static_cast<float>(*value));
  }
}

void add_fields(pcl::PCLPointCloud2& blob, const std::string& prefix) {
  for (const char* axis : {"x", "y", "z"}) {
    pcl::PCLPointField field;
    field.name = prefix + axis;
    field.offset = blob.point_step;
    field.datatype = pcl::PCLPointField::FLOAT32;
    field.count = 1;
    blob.fields.push_back(field);
    blob.point_step += sizeof(float);
  }
}

void fill(pcl::PCLPointCloud2& blob, std::size_t offset, const std::vector<float>& values) {
  for (std::size_t i = 0; 3 * i < values.size(); ++i)
    std::memcpy(&blob.data[i * blob.point_step + offset], &values[3 * i], 3 * sizeof(float));
}

}  // namespace

std::string read_obj(const std::string& path, pcl::PCLPointCloud2& blob) {
  std::ifstream in(path, std::ios::binary);
  std::vector<float> vertices, normals;
  std::string line;
  for (std::uint64_t number = 1; std::getline(in, line); ++number) {
    const auto words = words_of(line);
    if (words.empty()) continue;
    if (words[0] == "v") read_three(words, path, number, vertices);
    if (words[0] == "vn") read_three(words, path, number, normals);
  }
  if (vertices.empty()) throw FileFailure(path, "holds no points, expected OBJ lines 'v x y z'");
  if (vertices.size() / 3 > 0xffffffffu) throw FileFailure(path, "holds more points than PCL can");

  const bool with_normals = normals.size() == vertices.size();
  add_fields(blob, "");
  if (with_normals) add_fields(blob, "normal_");
  blob.width = static_cast<std::uint32_t>(vertices.size() / 3);
  blob.height = 1;
  blob.row_step = blob.point_step * blob.width;
  blob.is_dense = false;  // nobody has looked for NaN
  blob.data.resize(std::size_t{blob.point_step} * blob.width);
  fill(blob, 0, vertices);
  if (with_normals) fill(blob, 3 * sizeof(float), normals);
  if (normals.empty() || with_normals) return "";
  return "its " + std::to_string(normals.size() / 3) +
         " normals are left out, there is not one for each vertex";
}

}  // namespace cli
