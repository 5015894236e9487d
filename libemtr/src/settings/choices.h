#pragma once

#include <emtr/emtr.h>

#include <cstdint>

namespace emtr {

// The settings that are a choice are plain integers in the C struct; the engine compares them with
// these names only: `settings.fallback_search == When::Always`.

/// When to use what a setting can switch off.
enum class When : std::int32_t { Off = EMTR_OFF, Auto = EMTR_AUTO, Always = EMTR_ALWAYS };

/// Which structure answers the nearest-neighbor queries; all give the same bits.
enum class NeighborStructure : std::int32_t {
  Grid = EMTR_NEIGHBORS_GRID,
  KdTree = EMTR_NEIGHBORS_KDTREE,
  BruteForce = EMTR_NEIGHBORS_BRUTE_FORCE
};

/// In which points the dense stage looks for neighbors.
enum class DenseReference : std::int32_t {
  Dense = EMTR_REFERENCE_DENSE,
  Whole = EMTR_REFERENCE_WHOLE
};

/// Which scales of the source a run looks at.
enum class ScaleSearched : std::int32_t {
  Fixed = EMTR_SCALE_FIXED,
  Free = EMTR_SCALE_FREE,
  Bounded = EMTR_SCALE_BOUNDED,
  Units = EMTR_SCALE_UNITS
};

constexpr bool operator==(std::int32_t setting, When when) {
  return setting == static_cast<std::int32_t>(when);
}

constexpr bool operator==(std::int32_t setting, NeighborStructure structure) {
  return setting == static_cast<std::int32_t>(structure);
}

constexpr bool operator==(std::int32_t setting, DenseReference reference) {
  return setting == static_cast<std::int32_t>(reference);
}

constexpr bool operator==(std::int32_t setting, ScaleSearched scale) {
  return setting == static_cast<std::int32_t>(scale);
}

/// Tells whether to use what a setting can switch off, with Auto where `helps`.
constexpr bool in_use(std::int32_t setting, bool helps) {
  return setting == When::Always || (setting == When::Auto && helps);
}

}  // namespace emtr
