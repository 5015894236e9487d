#include "read/obj_reader.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <utility>
#include <vector>

#include "failure.h"
#include "read/blob.h"
#include "text/numbers.h"
#include "text/words.h"

namespace cli {
namespace {

class ObjLines {
 public:
  explicit ObjLines(const std::string& path) : path_(path) {}

  std::vector<double> vertices, normals;
  Faces faces;

  void add(const std::vector<std::string_view>& words) {
    ++line_;
    if (words.empty()) return;
    if (words[0] == "v") add_three(words, vertices);
    if (words[0] == "vn") add_three(words, normals);
    if (words[0] == "f") add_face(words);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw FileFailure(path_, "line " + std::to_string(line_) + what);
  }

  /// Reads the first three numbers behind the keyword; a color may follow them.
  void add_three(const std::vector<std::string_view>& words, std::vector<double>& values) const {
    if (words.size() < 4)
      fail(" has " + std::to_string(words.size() - 1) + " coordinates, expected at least 3");
    for (std::size_t i = 1; i < words.size(); ++i) {
      const auto value = parse_real(words[i]);
      if (!value) fail(": '" + shown(words[i]) + "' is not a number");
      if (i < 4) values.push_back(*value);
    }
  }

  /// Reads the vertex of each corner, "7", "7/2" or "-1//3": counted from 1, or from the last one.
  void add_face(const std::vector<std::string_view>& words) {
    for (std::size_t i = 1; i < words.size(); ++i) {
      std::string_view word = words[i].substr(0, words[i].find('/'));
      const bool from_last = word.substr(0, 1) == "-";
      if (from_last) word.remove_prefix(1);
      const auto number = parse_unsigned(word);
      const std::size_t known = vertices.size() / 3;
      if (!number || *number == 0 || *number > (from_last ? known : 0xfffffffeu))
        fail(": '" + shown(words[i]) + "' is not a vertex, expected one of " +
             std::to_string(known) + ", counted from 1");
      faces.corners.push_back(
          static_cast<std::uint32_t>(from_last ? known - *number : *number - 1));
    }
    faces.close();
  }

  const std::string& path_;
  std::uint64_t line_ = 0;
};

}  // namespace

void read_obj(CloudFile& cloud) {
  std::ifstream in(cloud.place, std::ios::binary);
  ObjLines lines(cloud.path);
  std::string line;
  while (std::getline(in, line)) lines.add(words_of(line));

  const auto& normals = lines.normals;
  const bool with_normals = !normals.empty() && normals.size() == lines.vertices.size();
  cloud.blob = with_normals ? doubles_blob({"x", "y", "z", "normal_x", "normal_y", "normal_z"})
                            : doubles_blob({"x", "y", "z"});
  reserve_points(cloud.blob, lines.vertices.size() / 3);
  for (std::size_t i = 0; i < lines.vertices.size(); i += 3) {
    double values[6] = {lines.vertices[i], lines.vertices[i + 1], lines.vertices[i + 2]};
    if (with_normals) std::copy_n(&normals[i], 3, values + 3);
    add_point(cloud.blob, values);
  }
  finish_blob(cloud.blob, cloud.path, "OBJ lines 'v x y z'");
  cloud.faces = std::move(lines.faces);
  require_corners(cloud.faces, cloud.size(), cloud.path);
  if (!normals.empty() && !with_normals)
    cloud.add_note("its " + std::to_string(normals.size() / 3) +
                   " normals are left out, there is not one for each vertex");
}

}  // namespace cli
