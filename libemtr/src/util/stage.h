#pragma once

#include <cstddef>

namespace emtr {

/// The stages of a registration, in the order in which they run.
enum class Stage {
  Normalization,
  ScaleSearch,
  Downsampling,
  Features,
  Matching,
  Seeds,
  Evolution,
  Candidates,
  FallbackSearch,
  Refinement,
  Verdict
};

constexpr std::size_t kStageCount = static_cast<std::size_t>(Stage::Verdict) + 1;

/// Returns the name that progress callbacks, timings and documents give the stage.
const char* stage_name(Stage stage);

}  // namespace emtr
