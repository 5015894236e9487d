#pragma once

#include <emtr/emtr.h>

#include <stdexcept>
#include <string>

namespace emtr {

/// The engine's exception; the C API turns it into a status and a message.
class Error : public std::runtime_error {
 public:
  Error(emtr_status status, const std::string& message)
      : std::runtime_error(message), status_(status) {}
  emtr_status status() const noexcept { return status_; }

 private:
  emtr_status status_;
};

}  // namespace emtr
