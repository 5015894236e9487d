#include "write/ply_face_output.h"

#include <algorithm>
#include <fstream>
#include <vector>

#include "read/text_body.h"

namespace cli {
namespace {

constexpr std::size_t kByte = 255;  // the most corners that programs expect of a face

void put(std::ostream& out, std::uint64_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) out.put(static_cast<char>(value >> 8 * i & 255));
}

int bytes_of_count(const Faces& faces) {
  for (std::size_t face = 0; face < faces.size(); ++face)
    if (faces.ends[face] - faces.begin_of(face) > kByte) return 4;
  return 1;
}

void copy(std::istream& in, std::ostream& out, std::uint64_t bytes) {
  std::vector<char> block(1 << 16);
  while (bytes > 0 && in && out) {
    const auto count = static_cast<std::streamsize>(std::min<std::uint64_t>(bytes, block.size()));
    in.read(block.data(), count);
    out.write(block.data(), in.gcount());
    bytes -= static_cast<std::uint64_t>(count);
  }
}

}  // namespace

bool add_ply_faces(const std::string& vertices, const Faces& faces, std::size_t behind,
                   const std::string& path) {
  std::ifstream in(vertices, std::ios::binary);
  std::ofstream out(path, std::ios::binary);
  const int bytes = bytes_of_count(faces);
  for (std::string line; line != "end_header" && std::getline(in, line);) {
    if (line == "element face 0")
      out << "element face " << faces.size() << "\nproperty list "
          << (bytes == 1 ? "uchar" : "uint") << " int vertex_indices\n";
    else
      out << line << '\n';
  }
  const std::uint64_t body = bytes_left(in);
  copy(in, out, body < behind ? 0 : body - behind);
  for (std::size_t face = 0; face < faces.size(); ++face) {
    const std::size_t begin = faces.begin_of(face);
    put(out, faces.ends[face] - begin, bytes);
    for (std::size_t i = begin; i < faces.ends[face]; ++i) put(out, faces.corners[i], 4);
  }
  copy(in, out, behind);
  out.close();
  return in.good() && out.good();
}

}  // namespace cli
