#pragma once

#include <cstring>

namespace emtr {

/// What a caller put into an enum of the C API. In C that may be any number; in C++ it is undefined
/// what reading one that the enum does not name gives, so its bytes are read instead.
template <class Enum>
int number_of(const Enum& value) noexcept {
  static_assert(sizeof(Enum) == sizeof(int), "an enum of the C API is as large as an int");
  int number;
  std::memcpy(&number, &value, sizeof number);
  return number;
}

}  // namespace emtr
