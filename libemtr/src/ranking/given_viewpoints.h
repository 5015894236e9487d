#pragma once

#include <optional>

#include "preprocessing/normalization.h"
#include "settings/settings.h"
#include "ranking/viewpoint.h"

namespace emtr {

/// What the caller says of where the sensors stood, each in its cloud's normalized frame. Neither
/// when free space is to say nothing. Throws Error when one is too far away.
struct GivenViewpoints {
  std::optional<Viewpoint> source, target;

  GivenViewpoints(const Settings& settings, const Normalization& normalization);
  bool both() const { return source && target; }
};

}  // namespace emtr
