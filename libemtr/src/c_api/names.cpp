// Names of statuses, reasons and stages, of the version and the kernel.
#include <emtr/emtr.h>

#include "c_api/guarded.h"
#include "kernels/kernels.h"
#include "util/enum_number.h"
#include "util/stage.h"

#define EMTR_TEXT_(x) #x
#define EMTR_TEXT(x) EMTR_TEXT_(x)

extern "C" {

const char* emtr_status_text(emtr_status status) {
  switch (emtr::number_of(status)) {
    case EMTR_OK:
      return "no error";
    case EMTR_ERROR_ARGUMENT:
      return "bad argument";
    case EMTR_ERROR_SETTING:
      return "bad setting";
    case EMTR_ERROR_CLOUD:
      return "cloud cannot be registered";
    case EMTR_ERROR_MEMORY:
      return "out of memory";
    case EMTR_ERROR_INTERNAL:
      return "internal error";
    case EMTR_ERROR_INTERRUPTED:
      return "interrupted";
  }
  return "unknown status";
}

const char* emtr_reason_name(emtr_reason reason) {
  switch (emtr::number_of(reason)) {
    case EMTR_REASON_REGISTERED:
      return "registered";
    case EMTR_REASON_LOW_OVERLAP:
      return "low_overlap";
    case EMTR_REASON_AMBIGUOUS:
      return "ambiguous";
    case EMTR_REASON_FEW_MATCHES:
      return "few_matches";
    case EMTR_REASON_INTERRUPTED:
      return "interrupted";
    case EMTR_REASON_DEGENERATE:
      return "degenerate";
    case EMTR_REASON_TIME_LIMIT:
      return "time_limit";
    case EMTR_REASON_MIRRORED:
      return "mirrored";
    case EMTR_REASON_SCALE:
      return "scale";
    case EMTR_REASON_FREE_SCALE:
      return "free_scale";
  }
  return "unknown";
}

const char* emtr_reason_text(emtr_reason reason) {
  switch (emtr::number_of(reason)) {
    case EMTR_REASON_REGISTERED:
      return "registered";
    case EMTR_REASON_LOW_OVERLAP:
      return "too few points of the clouds lie on each other";
    case EMTR_REASON_AMBIGUOUS:
      return "a clearly different pose fits about as well";
    case EMTR_REASON_FEW_MATCHES:
      return "too few feature matches";
    case EMTR_REASON_INTERRUPTED:
      return "interrupted";
    case EMTR_REASON_DEGENERATE:
      return "the surfaces leave a direction of the pose unconstrained";
    case EMTR_REASON_TIME_LIMIT:
      return "the time limit was reached";
    case EMTR_REASON_MIRRORED:
      return "the mirror image of the source fits better: one of the clouds seems to be mirrored";
    case EMTR_REASON_SCALE:
      return "the source fits better at another scale: see scale_factor; setting 'scale' searches "
             "it";
    case EMTR_REASON_FREE_SCALE:
      return "the surfaces leave the scale unconstrained";
  }
  return "unknown reason";
}

const char* emtr_stage_name(size_t index) {
  return index < emtr::kStageCount ? emtr::stage_name(static_cast<emtr::Stage>(index)) : nullptr;
}

const char* emtr_version(void) {
  return EMTR_TEXT(EMTR_VERSION_MAJOR) "." EMTR_TEXT(EMTR_VERSION_MINOR) "." EMTR_TEXT(
      EMTR_VERSION_PATCH);
}

const char* emtr_kernel_name(void) {
  const char* name = nullptr;
  emtr::guarded([&] { name = emtr::select_kernels().name; });
  return name;
}

}  // extern "C"
