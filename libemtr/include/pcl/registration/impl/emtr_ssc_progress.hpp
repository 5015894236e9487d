#pragma once

#include <emtr/emtr.h>

#include <exception>
#include <functional>

namespace pcl {
namespace detail {

/** \brief Carries the progress of the C library to a std::function, and what that throws past the
 * C library, which no exception may cross. */
class ProgressRelay {
 public:
  explicit ProgressRelay(const std::function<bool(const emtr_progress&)>& callback)
      : callback_(callback) {}

  /** \brief What to give the library, with the relay itself as the user's pointer. */
  emtr_progress_fn function() const { return callback_ ? &ProgressRelay::call : nullptr; }

  /** \brief What the callback threw; null when it did not. */
  const std::exception_ptr& thrown() const { return thrown_; }

 private:
  static int call(const emtr_progress* progress, void* user) {
    auto* relay = static_cast<ProgressRelay*>(user);
    try {
      return relay->callback_(*progress) ? 0 : 1;
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
