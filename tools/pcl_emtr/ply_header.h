#pragma once

#include <cstdint>
#include <istream>
#include <optional>
#include <string>
#include <vector>

namespace cli {

struct PlyProperty {
  std::string name;
  std::size_t bytes = 0;  // of its value; of a list, of one of its values
  bool real = false;      // float or double
  bool uchar = false;
  std::size_t count_bytes = 0;  // of a list's length, 0 for a scalar
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  bool has_list() const;
  /// The fewest bytes that one of them takes in a binary file, all lists being empty.
  std::uint64_t least_bytes() const;
};

struct PlyHeader {
  enum Format { Ascii, LittleEndian, BigEndian } format = Ascii;
  std::vector<PlyElement> elements;
  std::optional<std::uint64_t> columns, rows;  // obj_info num_cols and num_rows

  const PlyElement* find(const std::string& name) const;
};

/// Reads up to and with "end_header"; throws FileFailure.
PlyHeader read_ply_header(std::istream& in, const std::string& path);

}  // namespace cli
