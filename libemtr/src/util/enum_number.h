#pragma once

#include <cstring>

namespace emtr {

/// Returns the number that a caller put into an enum of the C API. A C program may put any number
/// there, and to read one that the enum does not name is undefined in C++, so this reads the bytes.
template <class Enum>
int number_of(const Enum& value) noexcept {
  static_assert(sizeof(Enum) == sizeof(int), "an enum of the C API is as large as an int");
  int number;
  std::memcpy(&number, &value, sizeof number);
  return number;
}

}  // namespace emtr
