#include "read/text_body.h"

#include <cstddef>

#include "failure.h"
#include "text/numbers.h"
#include "text/words.h"

namespace cli {

void check_rows(std::istream& in, const std::string& path, std::uint64_t rows, std::size_t columns,
                const std::string& kind) {
  std::string line;
  for (std::uint64_t row = 0; row < rows;) {
    if (!std::getline(in, line))
      throw FileFailure(path, "truncated: ends after " + std::to_string(row) + " of the " +
                                  std::to_string(rows) + " " + kind + "s that its header declares");
    const auto words = words_of(line);
    if (words.empty()) continue;
    ++row;
    const std::string name = kind + " " + std::to_string(row) + " of " + std::to_string(rows);
    if (columns && words.size() != columns)
      throw FileFailure(path, name + " has " + std::to_string(words.size()) + " values, expected " +
                                  std::to_string(columns) + (in.eof() ? "; truncated?" : ""));
    for (const auto word : words)
      if (!parse_real(word))
        throw FileFailure(path, name + ": '" + shown(word) + "' is not a number");
  }
}

void require_end(std::istream& in, const std::string& path, std::uint64_t rows,
                 const std::string& kind) {
  std::string line;
  while (std::getline(in, line))
    if (!words_of(line).empty())
      throw FileFailure(path, "holds more than the " + std::to_string(rows) + " " + kind +
                                  "s that its header declares");
}

std::uint64_t bytes_left(std::istream& in) {
  const auto here = in.tellg();
  in.seekg(0, std::ios::end);
  const auto end = in.tellg();
  in.seekg(here);
  return static_cast<std::uint64_t>(end - here);
}

}  // namespace cli
