#pragma once

#include <cstddef>
#include <cstdint>
#include <istream>
#include <optional>
#include <string>
#include <vector>

namespace cli {

struct PlyProperty {
  std::string name;
  std::size_t bytes = 0;        // size of its value, or of each value of a list
  std::uint8_t type = 0;        // of the same, as pcl::PCLPointField numbers it
  std::size_t count_bytes = 0;  // size of a list's length, 0 for a single value

  bool is_real() const;  // float or double
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  bool has_list() const;
  /// Returns the fewest bytes that one instance takes in a binary file, with all lists empty.
  std::uint64_t least_bytes() const;
};

struct PlyHeader {
  enum Format { Ascii, LittleEndian, BigEndian } format = Ascii;
  std::vector<PlyElement> elements;
  std::optional<std::uint64_t> columns, rows;  // obj_info num_cols and num_rows

  const PlyElement* find(const std::string& name) const;
};

/// Reads the lines up to "end_header", which it includes; throws FileFailure.
PlyHeader read_ply_header(std::istream& in, const std::string& path);

}  // namespace cli
