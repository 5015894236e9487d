#include "ranking/cube_map.h"

namespace emtr {

CubeMap::CubeMap(std::int32_t side) {
  for (Window& w : windows_) w = {side, side, -1, -1, 0};
}

std::size_t CubeMap::number_bins() {
  std::size_t count = 0;
  for (Window& w : windows_) {
    w.first = count;
    if (w.right >= w.left) count = w.index(w.right, w.bottom) + 1;
  }
  return count;
}

}  // namespace emtr
