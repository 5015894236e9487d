#include "mesh/faces.h"

#include "failure.h"

namespace cli {

void require_corners(const Faces& faces, std::size_t vertices, const std::string& path) {
  for (std::size_t face = 0; face < faces.size(); ++face)
    for (std::size_t i = faces.begin_of(face); i < faces.ends[face]; ++i)
      if (faces.corners[i] >= vertices)
        throw FileFailure(path, "face " + std::to_string(face + 1) + " has vertex " +
                                    std::to_string(faces.corners[i]) + ", counted from 0, of " +
                                    std::to_string(vertices));
}

}  // namespace cli
