#pragma once

#include <optional>

#include "preprocessing/normalization.h"
#include "ranking/viewpoint.h"
#include "settings/settings.h"

namespace emtr {

/// The sensors' places that the user gave, each in its cloud's normalized frame; neither when the
/// settings leave free space out. Throws Error when one is too far away.
struct GivenViewpoints {
  std::optional<Viewpoint> source, target;

  GivenViewpoints(const Settings& settings, const Normalization& normalization);
  bool both() const { return source && target; }
};

}  // namespace emtr
