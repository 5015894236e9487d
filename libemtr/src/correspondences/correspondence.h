#pragma once

#include <cstdint>
#include <vector>

namespace emtr {

/// Rows of a source point and of a target point that are held to be the same place.
struct Correspondence {
  std::int32_t source, target;
};

/// Returns the rows of one side, one for each correspondence.
inline std::vector<std::int32_t> rows_of(const std::vector<Correspondence>& correspondences,
                                         std::int32_t Correspondence::*side) {
  std::vector<std::int32_t> rows;
  rows.reserve(correspondences.size());
  for (const Correspondence& c : correspondences) rows.push_back(c.*side);
  return rows;
}

}  // namespace emtr
