#pragma once

#include <optional>

#include "../frame/frame.h"
#include "../settings.h"
#include "viewpoint.h"

namespace emtr {

/// What the caller says of where the sensors stood, each in its cloud's normalised frame. Neither
/// when free space is to say nothing. Throws Error when one is too far away.
struct GivenViewpoints {
  std::optional<Viewpoint> source, target;

  GivenViewpoints(const Settings& settings, const Frame& frame);
  bool both() const { return source && target; }
};

}  // namespace emtr
