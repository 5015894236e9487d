#pragma once

#include <array>
#include <optional>

namespace emtr {

/// The place from which a cloud was scanned, in the cloud's own normalized frame.
struct Viewpoint {
  double at[3] = {};
  /// How far the place is to be believed, 0 to 1: 1 where the user gave it.
  double trust = 1;
  bool given = true;  ///< by the user, and not estimated

  std::array<float, 3> in_float() const {
    return {static_cast<float>(at[0]), static_cast<float>(at[1]), static_cast<float>(at[2])};
  }
};

/// Tells whether the user gave the viewpoint.
inline bool is_given(const std::optional<Viewpoint>& viewpoint) {
  return viewpoint && viewpoint->given;
}

}  // namespace emtr
