#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace cli {

struct CsvRow {
  std::size_t line;  ///< of the file, where the row ends; the first is 1
  std::vector<std::string> cells;
};

/// Reads a table by RFC 4180: commas between cells, quotes around those with commas, quotes or line
/// breaks. Lines may end in LF or CRLF; empty ones are left out, and so is a byte order mark.
/// Throws FileFailure.
std::vector<CsvRow> read_csv(const std::string& path);

/// Returns the cells as a line of such a table, with LF behind it.
std::string csv_line(const std::vector<std::string>& cells);

}  // namespace cli
