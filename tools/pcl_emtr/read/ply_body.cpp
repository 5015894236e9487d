#include "read/ply_body.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string>
#include <utility>

#include "failure.h"
#include "read/blob.h"
#include "read/ply_header.h"

namespace cli {
namespace {

using Field = pcl::PCLPointField;

bool is_plain(const PlyHeader& header) {
  const PlyElement& first = header.elements.front();
  if (header.format != PlyHeader::LittleEndian || first.name != "vertex" ||
      header.find("range_grid") || header.columns || header.rows)
    return false;
  return std::none_of(first.properties.begin(), first.properties.end(), [](const PlyProperty& p) {
    return p.type == Field::UINT8 && (p.name == "intensity" || p.name.rfind("diffuse_", 0) == 0);
  });
}

/// PCL's name of a normal; other names are those of the file.
std::string field_name(const std::string& name) {
  const bool normal = name == "nx" || name == "ny" || name == "nz";
  return normal ? std::string("normal_") + name.back() : name;
}

/// Three or four bytes of color that follow each other; PCL packs them into one field.
struct Color {
  std::size_t offset = 0;  // of red, in a row of the file and in a point of the cloud
  std::size_t bytes = 0;   // in the file; 0: no colors
};

Color add_fields(pcl::PCLPointCloud2& blob, const PlyElement& vertex) {
  Color color;
  for (const PlyProperty& property : vertex.properties) {
    const auto is_byte = [&](const char* name) {
      return property.type == Field::UINT8 && property.name == name;
    };
    if (is_byte("red")) {
      color = {blob.point_step, 3};
      add_field(blob, "rgb", Field::FLOAT32);
    } else if (is_byte("alpha")) {
      color.bytes = 4;
      blob.fields.back().name = "rgba";
      blob.fields.back().datatype = Field::UINT32;
    } else if (!is_byte("green") && !is_byte("blue")) {
      add_field(blob, field_name(property.name), property.type);
    }
  }
  return color;
}

/// Makes room in each row for a packed color's fourth byte, and turns its order into blue, green,
/// red: from the last row to the first, since the rows lie in the same memory.
void pack_colors(pcl::PCLPointCloud2& blob, std::size_t row_bytes, const Color& color) {
  const std::size_t after = color.offset + color.bytes;  // in the file's row
  for (std::size_t i = blob.width; i-- > 0;) {
    const std::uint8_t* row = &blob.data[i * row_bytes];
    std::uint8_t* point = &blob.data[i * blob.point_step];
    const std::uint8_t* red = row + color.offset;
    const std::uint8_t packed[4] = {red[2], red[1], red[0],
                                    color.bytes == 4 ? red[3] : std::uint8_t{0}};
    std::memmove(point + color.offset + 4, row + after, row_bytes - after);
    std::memmove(point, row, color.offset);
    std::memcpy(point + color.offset, packed, sizeof packed);
  }
}

}  // namespace

bool read_ply_body(CloudFile& cloud) {
  std::ifstream in(cloud.place, std::ios::binary);
  const PlyHeader header = read_ply_header(in, cloud.path);
  if (!is_plain(header)) return false;
  const PlyElement& vertex = header.elements.front();
  pcl::PCLPointCloud2 blob;
  const Color color = add_fields(blob, vertex);
  const auto row_bytes = static_cast<std::size_t>(vertex.least_bytes());
  blob.data.resize(blob.point_step * vertex.count);
  finish_blob(blob, cloud.path, "vertices");
  in.read(reinterpret_cast<char*>(blob.data.data()),
          static_cast<std::streamsize>(row_bytes * blob.width));
  if (!in) throw FileFailure(cloud.path, "cannot be read: truncated");
  if (color.bytes) pack_colors(blob, row_bytes, color);
  cloud.blob = std::move(blob);
  return true;
}

}  // namespace cli
