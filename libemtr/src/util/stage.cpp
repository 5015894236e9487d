#include "util/stage.h"

#include <array>

namespace emtr {

const char* stage_name(Stage stage) {
  static constexpr std::array<const char*, kStageCount> kNames = {
      "normalization", "scale_search", "downsampling",    "features",   "matching", "seeds",
      "evolution",     "candidates",   "fallback_search", "refinement", "verdict"};
  return kNames.at(static_cast<std::size_t>(stage));
}

}  // namespace emtr
