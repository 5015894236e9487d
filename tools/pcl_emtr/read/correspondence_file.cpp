#include "read/correspondence_file.h"

#include <cerrno>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>

#include "failure.h"
#include "text/numbers.h"
#include "text/words.h"

namespace cli {

CorrespondenceFile read_correspondences(const std::string& path) {
  if (std::filesystem::is_directory(path))
    throw FileFailure(path, "is a directory, expected a text file of correspondences");
  std::ifstream in(path);
  if (!in) throw FileFailure(path, std::strerror(errno));
  CorrespondenceFile out;
  out.path = path;
  std::string line;
  for (std::size_t number = 1; std::getline(in, line); ++number) {
    const auto words = words_of(line);
    if (words.empty() || words[0][0] == '#') continue;
    const std::string place = "line " + std::to_string(number) + ": ";
    if (words.size() != 2)
      throw FileFailure(path, place + "expected two rows, of the source and of the target, got " +
                                  std::to_string(words.size()) + " words");
    for (const auto word : words) {
      const auto row = parse_unsigned(word);
      if (!row || *row > std::numeric_limits<std::int32_t>::max())
        throw FileFailure(path, place + "'" + shown(word) +
                                    "' is not a row, expected a whole "
                                    "number counted from 0");
      out.pairs.push_back(static_cast<std::int32_t>(*row));
    }
    out.lines.push_back(number);
  }
  if (out.lines.empty()) throw FileFailure(path, "has no correspondences");
  return out;
}

}  // namespace cli
