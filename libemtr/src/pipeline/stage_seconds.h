#pragma once

#include <array>
#include <cstddef>

#include "util/stage.h"

namespace emtr {

/// Wall seconds by stage, 0 for a stage that did not run.
struct StageSeconds {
  std::array<double, kStageCount> values{};

  double& operator[](Stage stage) { return values[static_cast<std::size_t>(stage)]; }
  double operator[](Stage stage) const { return values[static_cast<std::size_t>(stage)]; }
};

}  // namespace emtr
