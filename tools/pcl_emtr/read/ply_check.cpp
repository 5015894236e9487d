#include <pcl/PCLPointField.h>

#include <cstddef>
#include <fstream>

#include "failure.h"
#include "read/format_check.h"
#include "read/ply_grid.h"
#include "read/ply_header.h"
#include "read/text_body.h"

namespace cli {
namespace {

/// Throws when the file has fewer bytes than its elements take at least.
void check_size(const PlyHeader& header, const std::string& path, std::uint64_t available) {
  std::uint64_t left = available + 1;  // the last value of a text file needs no separator
  for (const auto& element : header.elements) {
    const bool text = header.format == PlyHeader::Ascii;
    const std::uint64_t each = text ? 2 * element.properties.size() : element.least_bytes();
    if (each == 0 && element.count > 0)
      throw FileFailure(path, "its PLY header gives element '" + element.name + "' no properties");
    if (each == 0) continue;
    if (element.count > left / each)
      throw FileFailure(path, "truncated: its header declares " + std::to_string(element.count) +
                                  " of element '" + element.name + "', " +
                                  std::to_string(available) + " bytes are left for all elements");
    left -= element.count * each;
  }
}

/// Returns the index of a property of bytes, or the number of properties when there is none.
std::size_t place_of(const PlyElement& element, const std::string& name) {
  std::size_t place = 0;
  while (place < element.properties.size() &&
         !(element.properties[place].name == name &&
           element.properties[place].type == pcl::PCLPointField::UINT8))
    ++place;
  return place;
}

/// Throws unless color bytes follow each other: PCL packs them into one field and assumes so.
void check_colors(const PlyElement& vertex, const std::string& path) {
  const std::size_t none = vertex.properties.size();
  for (const std::string prefix : {"", "diffuse_"}) {
    const std::size_t red = place_of(vertex, prefix + "red");
    const std::size_t green = place_of(vertex, prefix + "green");
    const std::size_t blue = place_of(vertex, prefix + "blue");
    const std::size_t alpha = prefix.empty() ? place_of(vertex, "alpha") : none;
    const bool no_color = red == none && green == none && blue == none;
    const bool in_order = blue != none && green + 1 == blue && red + 1 == green;
    const bool alpha_fits = alpha == none || (in_order && alpha == blue + 1);
    if (!(no_color || in_order) || !alpha_fits)
      throw FileFailure(path,
                        "its colors cannot be read, expected uchar red, green, blue and "
                        "perhaps alpha, one after the other");
  }
}

/// Throws on a list: PCL loses its place in vertices whose length differs, and behind any list.
void check_no_list(const PlyElement& vertex, const std::string& path) {
  for (const auto& property : vertex.properties)
    if (property.count_bytes)
      throw FileFailure(
          path, "its vertices have a list '" + property.name + "', expected single values only");
}

/// Throws on two properties of one name: PCL cannot read them, and does not say why.
void check_unique_names(const PlyElement& vertex, const std::string& path) {
  for (auto one = vertex.properties.begin(); one != vertex.properties.end(); ++one)
    for (auto other = vertex.properties.begin(); other != one; ++other)
      if (one->name == other->name)
        throw FileFailure(path, "its vertices have the property '" + one->name + "' twice");
}

}  // namespace

std::uint64_t check_ply(const std::string& place, const std::string& path) {
  std::ifstream in(place, std::ios::binary);
  const PlyHeader header = read_ply_header(in, path);
  const PlyElement* vertex = header.find("vertex");
  if (!vertex || vertex->count == 0) throw FileFailure(path, "holds no points (PLY vertices)");
  check_no_list(*vertex, path);
  check_unique_names(*vertex, path);
  check_colors(*vertex, path);
  check_size(header, path, bytes_left(in));
  check_grid(in, header, path, vertex->count);
  if (header.format == PlyHeader::Ascii) {
    for (const auto& element : header.elements)
      check_rows(in, path, element.count, element.has_list() ? 0 : element.properties.size(),
                 element.name);
    require_end(in, path, header.elements.back().count, header.elements.back().name);
  }
  return vertex->count;
}

}  // namespace cli
