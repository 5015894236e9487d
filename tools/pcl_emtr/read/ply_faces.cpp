#include "read/ply_faces.h"

#include <array>
#include <fstream>

#include "failure.h"
#include "read/ply_header.h"
#include "text/numbers.h"
#include "text/words.h"

namespace cli {
namespace {

bool is_corners(const PlyProperty& property) {
  return property.count_bytes > 0 && !property.is_real() &&
         (property.name == "vertex_indices" || property.name == "vertex_index");
}

/// Adds one corner; what does not fit into 32 bits is no vertex of any file.
void add_corner(Faces& faces, std::uint64_t row) {
  faces.corners.push_back(row < 0xffffffffu ? static_cast<std::uint32_t>(row) : 0xffffffffu);
}

/// Reads a line of values; `element` is the faces' own, or its corners are left out.
void read_line(const std::vector<std::string_view>& words, const PlyElement& element,
               const std::string& path, Faces& faces) {
  std::size_t at = 0;
  for (const auto& property : element.properties) {
    std::uint64_t count = 1;
    if (property.count_bytes && at < words.size())
      count = parse_unsigned(words[at++]).value_or(words.size());
    if (count > words.size() - at)
      throw FileFailure(path, "face " + std::to_string(faces.size() + 1) + " has " +
                                  std::to_string(words.size()) + " values, expected more");
    if (is_corners(property)) {
      for (std::uint64_t i = 0; i < count; ++i)
        add_corner(faces, parse_unsigned(words[at + i]).value_or(0xffffffffu));
      faces.close();
    }
    at += count;
  }
}

void read_text(std::istream& in, const PlyHeader& header, const std::string& path, Faces& faces) {
  std::string line;
  for (const auto& element : header.elements) {
    const bool face = element.name == "face";
    for (std::uint64_t row = 0; row < element.count && std::getline(in, line);) {
      const auto words = words_of(line);
      if (words.empty()) continue;
      if (face) read_line(words, element, path, faces);
      ++row;
    }
    if (face) return;
  }
}

std::uint64_t read_whole(std::istream& in, std::size_t bytes, bool big_endian) {
  std::array<unsigned char, 8> raw{};
  in.read(reinterpret_cast<char*>(raw.data()), static_cast<std::streamsize>(bytes));
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < bytes; ++i) value = value << 8 | raw[big_endian ? i : bytes - 1 - i];
  return value;
}

void read_row(std::istream& in, const PlyElement& element, bool big_endian, Faces* faces) {
  for (const auto& property : element.properties) {
    std::uint64_t count = 1;
    if (property.count_bytes) count = read_whole(in, property.count_bytes, big_endian);
    if (faces && is_corners(property)) {
      for (std::uint64_t i = 0; i < count && in; ++i)
        add_corner(*faces, read_whole(in, property.bytes, big_endian));
      faces->close();
    } else {
      in.ignore(static_cast<std::streamsize>(count * property.bytes));
    }
  }
}

void read_binary(std::istream& in, const PlyHeader& header, const std::string& path, Faces& faces) {
  const bool big_endian = header.format == PlyHeader::BigEndian;
  for (const auto& element : header.elements) {
    const bool face = element.name == "face";
    if (!face && !element.has_list()) {
      in.seekg(static_cast<std::streamoff>(element.count * element.least_bytes()), std::ios::cur);
      continue;
    }
    for (std::uint64_t row = 0; row < element.count; ++row) {
      read_row(in, element, big_endian, face ? &faces : nullptr);
      if (!in) throw FileFailure(path, "truncated: ends in or before its faces");
    }
    if (face) return;
  }
}

}  // namespace

void read_ply_faces(CloudFile& cloud) {
  std::ifstream in(cloud.place, std::ios::binary);
  const PlyHeader header = read_ply_header(in, cloud.path);
  const PlyElement* face = header.find("face");
  if (!face || face->count == 0) return;
  // A scan in a range grid has its points in other rows than its file.
  if (const PlyElement* grid = header.find("range_grid"); grid && grid->count > 0) return;
  header.format == PlyHeader::Ascii ? read_text(in, header, cloud.path, cloud.faces)
                                    : read_binary(in, header, cloud.path, cloud.faces);
  require_corners(cloud.faces, cloud.size(), cloud.path);
}

}  // namespace cli
