#pragma once

#include <cfenv>

namespace emtr {

/// Sets the default floating-point environment while it lives: rounding to nearest, and no denormal
/// taken for zero, whatever the caller or a library of its that was built with -ffast-math has set.
class DefaultArithmetic {
 public:
  DefaultArithmetic() {
    std::fegetenv(&callers_);
    std::fesetenv(FE_DFL_ENV);
  }
  ~DefaultArithmetic() { std::fesetenv(&callers_); }
  DefaultArithmetic(const DefaultArithmetic&) = delete;
  DefaultArithmetic& operator=(const DefaultArithmetic&) = delete;

 private:
  std::fenv_t callers_;
};

}  // namespace emtr
