#pragma once

#include <emtr/emtr.h>

#include <exception>
#include <functional>

namespace pcl {
namespace detail {

/** \brief Passes the progress of the C library to a std::function, and carries the function's
 * exception past the C library, which no exception may cross. */
class ProgressRelay {
 public:
  explicit ProgressRelay(const std::function<bool(const emtr_progress&)>& callback)
      : callback_(callback) {}

  /** \brief Returns the function for the library; its user pointer is the relay itself. Null if
   * there is no callback. */
  emtr_progress_fn function() const { return callback_ ? &ProgressRelay::call : nullptr; }

  /** \brief Returns the exception that the callback threw; null for none. */
  const std::exception_ptr& thrown() const { return thrown_; }

 private:
  static int call(const emtr_progress* progress, void* user) {
    auto* relay = static_cast<ProgressRelay*>(user);
    try {
      return relay->callback_(*progress) ? 1 : 0;
    } catch (...) {
      relay->thrown_ = std::current_exception();
      return 1;
    }
  }

  const std::function<bool(const emtr_progress&)>& callback_;
  std::exception_ptr thrown_;
};

}  // namespace detail
}  // namespace pcl
