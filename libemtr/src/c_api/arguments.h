#pragma once

#include <emtr/emtr.h>

#include <cstring>
#include <string>

#include "geometry/similarity.h"
#include "settings/settings.h"
#include "util/error.h"

namespace emtr {

/// Returns what the pointer points to; throws Error naming the argument when it is null.
template <class T>
T& required(T* pointer, const char* name) {
  if (!pointer) throw Error(EMTR_ERROR_ARGUMENT, std::string(name) + " is null");
  return *pointer;
}

/// Copies an info to a caller that was compiled with this header or a later one, and sets the
/// fields that this version does not know to zero. Throws Error when the caller's struct is too
/// small.
template <class Info>
void copy_info(const Info& info, Info* out, std::size_t size) {
  required(out, "info");
  if (size < sizeof(Info))
    throw Error(EMTR_ERROR_ARGUMENT, "size is " + std::to_string(size) + ", expected at least " +
                                         std::to_string(sizeof(Info)));
  std::memset(static_cast<void*>(out), 0, size);
  std::memcpy(static_cast<void*>(out), &info, sizeof(Info));
}

/// Returns the settings; throws Error when the pointer is null or the size field does not match
/// this library.
Settings& checked(emtr_settings* settings);
const Settings& checked(const emtr_settings* settings);

/// Returns the settings as checked() does, or preset "default" for a null pointer.
Settings settings_or_preset(const emtr_settings* settings);

/// Returns the similarity of a matrix; throws Error when it is none.
Similarity checked_similarity(const double transformation[16]);

/// Returns the pose of a matrix; throws Error when it is not a rigid transformation.
Rigid checked_pose(const double transformation[16]);

/// Returns how many threads to use for this value of the setting `threads`; throws Error when it is
/// out of its range.
int checked_threads(std::int32_t threads);

/// Returns the index; throws Error when it is not below `count`.
std::size_t checked_index(std::size_t index, std::size_t count);

}  // namespace emtr
