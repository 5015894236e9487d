#pragma once

#include <emtr/emtr.h>

#include "input.h"

namespace fuzz {

/// Returns whether a call of the C API succeeded. Requires of a failed call a status that blames
/// the input, and a message: an internal error is a defect, whatever the input.
inline bool accepted(emtr_status status) {
  if (status == EMTR_OK) return true;
  require(status == EMTR_ERROR_ARGUMENT || status == EMTR_ERROR_SETTING ||
          status == EMTR_ERROR_CLOUD);
  require(*emtr_error_message() != '\0');
  return false;
}

}  // namespace fuzz
