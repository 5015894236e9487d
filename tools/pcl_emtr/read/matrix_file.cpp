#include "read/matrix_file.h"

#include <cerrno>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "failure.h"
#include "text/numbers.h"
#include "text/words.h"

namespace cli {

void read_matrix(const std::string& path, double (&matrix)[16]) {
  if (std::filesystem::is_directory(path))
    throw FileFailure(path, "is a directory, expected a text file of a 4x4 matrix");
  std::ifstream in(path);
  if (!in) throw FileFailure(path, std::strerror(errno));
  std::string line;
  std::size_t row = 0;
  while (std::getline(in, line)) {
    const auto words = words_of(line);
    if (words.empty() || words[0][0] == '#') continue;
    if (row == 4 || words.size() != 4)
      throw FileFailure(path, "expected a 4x4 matrix, 4 lines of 4 numbers");
    for (std::size_t column = 0; column < 4; ++column) {
      const auto value = parse_real(words[column]);
      if (!value || !std::isfinite(*value))
        throw FileFailure(
            path, "'" + shown(words[column]) + "' is not a finite number, expected a 4x4 matrix");
      matrix[4 * row + column] = *value;
    }
    ++row;
  }
  if (row != 4) throw FileFailure(path, "expected a 4x4 matrix, 4 lines of 4 numbers");
}

}  // namespace cli
