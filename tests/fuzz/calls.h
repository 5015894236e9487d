#pragma once

#include <emtr/emtr.h>

#include "input.h"

namespace fuzz {

/// A call of the C API that may be refused: by a status that exists and with words for it. True
/// when it was not. An internal error is a defect, whatever the input.
inline bool accepted(emtr_status status) {
  if (status == EMTR_OK) return true;
  require(status == EMTR_ERROR_ARGUMENT || status == EMTR_ERROR_SETTING ||
          status == EMTR_ERROR_CLOUD);
  require(*emtr_error_message() != '\0');
  return false;
}

}  // namespace fuzz
