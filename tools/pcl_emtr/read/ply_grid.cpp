#include "read/ply_grid.h"

#include <array>
#include <cstddef>

#include "failure.h"
#include "text/numbers.h"
#include "text/words.h"

namespace cli {
namespace {

constexpr const char* kGrid = "range_grid";

void check_size(const PlyHeader& header, const std::string& path, std::uint64_t vertices) {
  if (!header.columns && !header.rows) return;
  const std::uint64_t places = header.columns.value_or(1) * header.rows.value_or(1);
  const PlyElement* grid = header.find(kGrid);
  const std::uint64_t points = grid && grid->count > 0 ? grid->count : vertices;
  const bool complete = header.columns && header.rows;
  // PCL keeps the vertices in these places before it sorts them into the grid.
  if (complete && places == points && places >= vertices) return;
  throw FileFailure(path, "cannot be read: its obj_info lays out num_cols x num_rows = " +
                              std::to_string(places) + " points, but it has " +
                              std::to_string(places == points ? vertices : points));
}

[[noreturn]] void refuse_index(const std::string& path, std::uint64_t row, const std::string& index,
                               std::uint64_t vertices) {
  throw FileFailure(path, std::string(kGrid) + " " + std::to_string(row + 1) + " names vertex " +
                              index + ", expected one below " + std::to_string(vertices));
}

void check_text(std::istream& in, const PlyHeader& header, const std::string& path,
                std::uint64_t vertices) {
  std::string line;
  for (const auto& element : header.elements) {
    for (std::uint64_t row = 0; row < element.count && std::getline(in, line);) {
      const auto words = words_of(line);
      if (words.empty()) continue;
      for (std::size_t i = 1; element.name == kGrid && i < words.size(); ++i) {
        const auto index = parse_unsigned(words[i]);
        if (!index || *index >= vertices) refuse_index(path, row, shown(words[i]), vertices);
      }
      ++row;
    }
    if (element.name == kGrid) return;
  }
}

/// Reads one whole number of a binary file as if it had no sign, so that a negative one becomes a
/// large one.
std::uint64_t read_whole(std::istream& in, const std::string& path, std::size_t bytes,
                         bool big_endian) {
  std::array<unsigned char, 8> raw{};
  if (!in.read(reinterpret_cast<char*>(raw.data()), static_cast<std::streamsize>(bytes)))
    throw FileFailure(path, std::string("truncated: ends in or before its ") + kGrid);
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < bytes; ++i) value = value << 8 | raw[big_endian ? i : bytes - 1 - i];
  return value;
}

void check_binary(std::istream& in, const PlyHeader& header, const std::string& path,
                  std::uint64_t vertices) {
  const bool big_endian = header.format == PlyHeader::BigEndian;
  for (const auto& element : header.elements) {
    const bool grid = element.name == kGrid;
    if (!element.has_list()) {
      in.ignore(static_cast<std::streamsize>(element.count * element.least_bytes()));
      continue;
    }
    for (std::uint64_t row = 0; row < element.count; ++row) {
      for (const auto& property : element.properties) {
        std::uint64_t n = 1;
        if (property.count_bytes) n = read_whole(in, path, property.count_bytes, big_endian);
        for (; n > 0; --n) {
          const std::uint64_t value = read_whole(in, path, property.bytes, big_endian);
          if (grid && value >= vertices) refuse_index(path, row, std::to_string(value), vertices);
        }
      }
    }
    if (grid) return;
  }
}

}  // namespace

void check_grid(std::istream& in, const PlyHeader& header, const std::string& path,
                std::uint64_t vertices) {
  check_size(header, path, vertices);
  const PlyElement* grid = header.find(kGrid);
  if (!grid || grid->count == 0) return;
  if (grid->properties.size() != 1 || !grid->has_list() || grid->properties[0].is_real())
    throw FileFailure(path, std::string("its element ") + kGrid +
                                " has other properties than one list of whole numbers");
  const auto start = in.tellg();
  header.format == PlyHeader::Ascii ? check_text(in, header, path, vertices)
                                    : check_binary(in, header, path, vertices);
  in.clear();
  in.seekg(start);
}

}  // namespace cli
