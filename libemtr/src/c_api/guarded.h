#pragma once

#include <emtr/emtr.h>

#include "util/cancellation.h"

namespace emtr {

/// Calls the body, which may throw; what it throws becomes a status and this thread's message.
emtr_status guarded(void (*call)(const void* body), const void* body) noexcept;

template <class Body>
emtr_status guarded(const Body& body) noexcept {
  return guarded([](const void* own) { (*static_cast<const Body*>(own))(); }, &body);
}

/// Of this thread, as a run asks it; null when there is none.
OnProgress interrupt_function();

/// The caller's, or else this thread's interrupt.
OnProgress progress_function(emtr_progress_fn progress, void* user);

}  // namespace emtr
