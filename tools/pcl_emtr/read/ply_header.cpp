#include "read/ply_header.h"

#include <pcl/common/io.h>

#include <cstddef>
#include <map>

#include "failure.h"
#include "text/numbers.h"
#include "text/words.h"

namespace cli {
namespace {

using Field = pcl::PCLPointField;

std::uint8_t type_of(std::string_view word, const std::string& path) {
  static const std::map<std::string_view, std::uint8_t> types = {
      {"char", Field::INT8},      {"int8", Field::INT8},       {"uchar", Field::UINT8},
      {"uint8", Field::UINT8},    {"short", Field::INT16},     {"int16", Field::INT16},
      {"ushort", Field::UINT16},  {"uint16", Field::UINT16},   {"int", Field::INT32},
      {"int32", Field::INT32},    {"uint", Field::UINT32},     {"uint32", Field::UINT32},
      {"float", Field::FLOAT32},  {"float32", Field::FLOAT32}, {"double", Field::FLOAT64},
      {"float64", Field::FLOAT64}};
  const auto found = types.find(word);
  if (found == types.end())
    throw FileFailure(path, "its PLY header has an unknown type '" + shown(word) + "'");
  return found->second;
}

std::size_t bytes_of(std::uint8_t type) {
  return static_cast<std::size_t>(pcl::getFieldSize(type));
}

PlyProperty property_of(const std::vector<std::string_view>& words, const std::string& path) {
  PlyProperty property;
  if (words.size() == 5 && words[1] == "list") {
    property.count_bytes = bytes_of(type_of(words[2], path));
  } else if (words.size() != 3) {
    throw FileFailure(path, "its PLY header has a property without type or name");
  }
  property.type = type_of(words[words.size() - 2], path);
  property.bytes = bytes_of(property.type);
  property.name = words.back();
  return property;
}

PlyElement element_of(const std::vector<std::string_view>& words, const std::string& path) {
  const auto count = words.size() == 3 ? parse_unsigned(words[2]) : std::nullopt;
  if (!count || *count > 0xffffffffu)
    throw FileFailure(path,
                      "its PLY header has an element without a name and a count from 0 to "
                      "4294967295");
  PlyElement element;
  element.name = words[1];
  element.count = *count;
  return element;
}

PlyHeader::Format format_of(const std::vector<std::string_view>& words, const std::string& path) {
  if (words.size() == 3 && words[2] == "1.0") {
    if (words[1] == "ascii") return PlyHeader::Ascii;
    if (words[1] == "binary_little_endian") return PlyHeader::LittleEndian;
    if (words[1] == "binary_big_endian") return PlyHeader::BigEndian;
  }
  throw FileFailure(path,
                    "its PLY header has an unknown format, expected ascii, "
                    "binary_little_endian or binary_big_endian, version 1.0");
}

/// Reads num_cols and num_rows, the two words of obj_info that PCL acts on.
void read_obj_info(PlyHeader& header, const std::string& line,
                   const std::vector<std::string_view>& words, const std::string& path) {
  if (line.compare(0, words[0].size(), words[0]) != 0)
    throw FileFailure(path, "its PLY header has a line 'obj_info' that begins with a blank");
  if (words.size() < 2 || (words[1] != "num_cols" && words[1] != "num_rows")) return;
  const auto count = words.size() == 3 ? parse_unsigned(words[2]) : std::nullopt;
  if (!count || *count == 0 || *count > 0x7fffffffu)
    throw FileFailure(path, "its PLY header has obj_info " + shown(words[1]) +
                                " without a count from 1 to 2147483647");
  (words[1] == "num_cols" ? header.columns : header.rows) = *count;
}

}  // namespace

bool PlyProperty::is_real() const { return type == Field::FLOAT32 || type == Field::FLOAT64; }

bool PlyElement::has_list() const {
  for (const auto& property : properties)
    if (property.count_bytes) return true;
  return false;
}

std::uint64_t PlyElement::least_bytes() const {
  std::uint64_t sum = 0;
  for (const auto& property : properties)
    sum += property.count_bytes ? property.count_bytes : property.bytes;
  return sum;
}

const PlyElement* PlyHeader::find(const std::string& name) const {
  for (const auto& element : elements)
    if (element.name == name) return &element;
  return nullptr;
}

PlyHeader read_ply_header(std::istream& in, const std::string& path) {
  std::string line;
  if (!std::getline(in, line) || words_of(line) != std::vector<std::string_view>{"ply"})
    throw FileFailure(path, "not a PLY file, expected a first line 'ply'");
  PlyHeader header;
  bool has_format = false;
  while (std::getline(in, line) && !in.eof()) {
    const auto words = words_of(line);
    if (words.empty() || words[0] == "comment") continue;
    if (words[0] == "obj_info") {
      read_obj_info(header, line, words, path);
    } else if (words[0] == "format") {
      header.format = format_of(words, path);
      has_format = true;
    } else if (words[0] == "element") {
      header.elements.push_back(element_of(words, path));
    } else if (words[0] == "property" && !header.elements.empty()) {
      header.elements.back().properties.push_back(property_of(words, path));
    } else if (words[0] == "end_header") {
      if (!has_format) throw FileFailure(path, "its PLY header has no format line");
      return header;
    } else {
      throw FileFailure(path, "its PLY header has an unknown line '" + shown(words[0]) + "'");
    }
  }
  throw FileFailure(path, "truncated: its PLY header has no line 'end_header'");
}

}  // namespace cli
