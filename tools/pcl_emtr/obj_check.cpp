#include <fstream>

#include "failure.h"
#include "format_check.h"
#include "numbers.h"

namespace cli {

ObjCounts check_obj(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  ObjCounts counts{0, 0};
  std::string line;
  for (std::uint64_t number = 1; std::getline(in, line); ++number) {
    const auto words = words_of(line);
    if (words.empty() || (words[0] != "v" && words[0] != "vn")) continue;
    if (line.compare(0, words[0].size() + 1, std::string(words[0]) + " ") != 0)
      throw FileFailure(path, "line " + std::to_string(number) +
                                  ": expected 'v' or 'vn' at its beginning and a blank after it");
    ++(words[0] == "v" ? counts.vertices : counts.normals);
    if (words.size() < 4)
      throw FileFailure(path, "line " + std::to_string(number) + " has " +
                                  std::to_string(words.size() - 1) +
                                  " coordinates, expected at least 3");
    for (std::size_t i = 1; i < words.size(); ++i)
      if (!parse_real(words[i]))
        throw FileFailure(
            path, "line " + std::to_string(number) + ": '" + shown(words[i]) + "' is not a number");
  }
  if (counts.vertices == 0)
    throw FileFailure(path, "holds no points, expected OBJ lines 'v x y z'");
  return counts;
}

}  // namespace cli
