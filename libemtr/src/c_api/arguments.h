#pragma once

#include <emtr/emtr.h>

#include <cstring>
#include <string>

#include "util/error.h"
#include "geometry/rigid.h"
#include "settings/settings.h"

namespace emtr {

template <class T>
T& required(T* pointer, const char* name) {
  if (!pointer) throw Error(EMTR_ERROR_ARGUMENT, std::string(name) + " is null");
  return *pointer;
}

/// To a caller who was compiled with this header or a later one, whose further fields become zero.
template <class Info>
void hand_out(const Info& info, Info* out, std::size_t size) {
  required(out, "info");
  if (size < sizeof(Info))
    throw Error(EMTR_ERROR_ARGUMENT, "size is " + std::to_string(size) + ", expected at least " +
                                         std::to_string(sizeof(Info)));
  std::memset(static_cast<void*>(out), 0, size);
  std::memcpy(static_cast<void*>(out), &info, sizeof(Info));
}

/// Of this version's size. Throws Error.
Settings& checked(emtr_settings* settings);
/// Null: preset "default".
Settings settings_or_preset(const emtr_settings* settings);

/// Throws Error when the matrix is not rigid.
Rigid given_rigid(const double T[16]);

/// As the setting `threads`. Throws Error.
int given_threads(std::int32_t threads);

}  // namespace emtr
