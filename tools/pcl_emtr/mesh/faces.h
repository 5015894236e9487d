#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace cli {

/// Polygons over the vertices of a mesh.
struct Faces {
  std::vector<std::uint32_t> corners;  // rows of vertices, counted from 0, one face after the other
  std::vector<std::size_t> ends;       // where in `corners` each face ends

  std::size_t size() const { return ends.size(); }
  bool empty() const { return ends.empty(); }
  std::size_t begin_of(std::size_t face) const { return face == 0 ? 0 : ends[face - 1]; }

  /// Ends the face whose corners were added last.
  void close() { ends.push_back(corners.size()); }
};

/// Throws FileFailure about `path` when a face has a corner that is none of the vertices.
void require_corners(const Faces& faces, std::size_t vertices, const std::string& path);

}  // namespace cli
