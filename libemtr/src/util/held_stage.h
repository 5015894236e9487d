#pragma once

#include "util/cancellation.h"
#include "util/stage.h"

namespace emtr {

/// Reports whole registrations as one stage of another.
class HeldStage {
 public:
  HeldStage(CancellationToken& token, Stage stage) : token_(token) {
    token.hold_stage(stage_name(stage));
  }
  ~HeldStage() { token_.hold_stage(nullptr); }
  HeldStage(const HeldStage&) = delete;
  HeldStage& operator=(const HeldStage&) = delete;

 private:
  CancellationToken& token_;
};

}  // namespace emtr
