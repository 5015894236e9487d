#include "read/stl_reader.h"

#include <array>
#include <cstring>
#include <fstream>
#include <unordered_map>

#include "failure.h"
#include "read/blob.h"
#include "read/text_body.h"
#include "text/numbers.h"
#include "text/words.h"

namespace cli {
namespace {

using Corner = std::array<double, 3>;

struct Hash {
  std::size_t operator()(const Corner& corner) const {
    std::uint64_t sum = 0;
    for (const double value : corner) {
      std::uint64_t bits;
      std::memcpy(&bits, &value, sizeof bits);
      sum = (sum ^ bits) * 0x9e3779b97f4a7c15u;
      sum ^= sum >> 32;
    }
    return sum;
  }
};

/// Numbers the vertices in the order in which they come first, and collects the triangles.
class Triangles {
 public:
  explicit Triangles(CloudFile& cloud) : cloud_(cloud) {
    cloud.blob = doubles_blob({"x", "y", "z"});
  }

  void add(Corner corner) {
    for (double& value : corner) value += 0.0;  // -0 and 0 are one place
    const auto [found, is_new] = rows_.emplace(corner, static_cast<std::uint32_t>(rows_.size()));
    if (is_new) add_point(cloud_.blob, corner.data());
    cloud_.faces.corners.push_back(found->second);
    if (cloud_.faces.corners.size() % 3 == 0) cloud_.faces.close();
  }

  bool complete() const { return cloud_.faces.corners.size() % 3 == 0; }

 private:
  CloudFile& cloud_;
  std::unordered_map<Corner, std::uint32_t, Hash> rows_;
};

void read_text(std::istream& in, const std::string& path, Triangles& triangles) {
  std::string line;
  bool ended = false;
  for (std::uint64_t number = 1; std::getline(in, line); ++number) {
    const auto words = words_of(line);
    if (words.empty()) continue;
    ended = words[0] == "endsolid";
    if (words[0] == "endloop" && !triangles.complete())
      throw FileFailure(
          path, "line " + std::to_string(number) + " ends a face that has not three vertices");
    if (words[0] != "vertex") continue;
    Corner corner{};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto value = i + 1 < words.size() ? parse_real(words[i + 1]) : std::nullopt;
      if (!value || words.size() != 4)
        throw FileFailure(path, "line " + std::to_string(number) + ": expected 'vertex x y z'");
      corner[i] = *value;
    }
    triangles.add(corner);
  }
  if (!ended) throw FileFailure(path, "truncated: has no last line 'endsolid'");
}

constexpr std::size_t kHead = 84, kTriangle = 50;

std::uint64_t read_count(std::istream& in) {
  std::array<unsigned char, kHead> head{};
  in.read(reinterpret_cast<char*>(head.data()), head.size());
  std::uint64_t count = 0;
  for (std::size_t i = 4; i-- > 0;) count = count << 8 | head[80 + i];
  return count;
}

/// Reads the triangles of a binary file: a normal, three corners and two bytes more for each.
void read_binary(std::istream& in, std::uint64_t count, Triangles& triangles) {
  std::array<char, kTriangle> bytes{};
  for (std::uint64_t i = 0; i < count; ++i) {
    in.read(bytes.data(), bytes.size());
    std::array<float, 12> values{};
    std::memcpy(values.data(), bytes.data(), sizeof values);
    for (std::size_t k = 3; k < 12; k += 3)
      triangles.add({values[k], values[k + 1], values[k + 2]});
  }
}

}  // namespace

void read_stl(CloudFile& cloud) {
  std::ifstream in(cloud.place, std::ios::binary);
  const std::uint64_t bytes = bytes_left(in);
  const std::uint64_t count = bytes < kHead ? 0 : read_count(in);
  Triangles triangles(cloud);
  // The text of a binary file may begin with "solid" too; its size is exact.
  if (bytes >= kHead && bytes == kHead + kTriangle * count) {
    read_binary(in, count, triangles);
  } else {
    in.clear();
    in.seekg(0);
    std::string word;
    if (!(in >> word) || word != "solid")
      throw FileFailure(cloud.path,
                        "truncated or not an STL file, expected a first word 'solid', or " +
                            std::to_string(kHead) + " bytes and then 50 for each of " +
                            std::to_string(count) + " triangles");
    in.seekg(0);
    read_text(in, cloud.path, triangles);
  }
  finish_blob(cloud.blob, cloud.path, "STL facets");
}

}  // namespace cli
