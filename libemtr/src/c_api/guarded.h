#pragma once

#include <emtr/emtr.h>

#include "util/cancellation.h"

namespace emtr {

/// Calls the body in the default floating-point environment. Turns what it throws into a status and
/// this thread's error message.
emtr_status guarded(void (*call)(const void* body), const void* body) noexcept;

template <class Body>
emtr_status guarded(const Body& body) noexcept {
  return guarded([](const void* own) { (*static_cast<const Body*>(own))(); }, &body);
}

/// Returns this thread's interrupt as a run asks it, null when there is none.
OnProgress interrupt_function();

/// Returns the user's progress function as a run calls it, or else this thread's interrupt.
OnProgress progress_function(emtr_progress_fn progress, void* user);

}  // namespace emtr
