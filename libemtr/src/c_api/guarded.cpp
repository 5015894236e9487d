#include "c_api/guarded.h"

#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>

#include "util/default_arithmetic.h"
#include "util/error.h"

namespace emtr {
namespace {

thread_local std::string last_error;

struct Interrupt {
  emtr_interrupt_fn ask = nullptr;
  void* user = nullptr;
};
thread_local Interrupt interrupt;

/// Keeps a message; a short one where there is no memory for it.
void keep_message(const char* prefix, const char* text) noexcept {
  try {
    last_error = std::string(prefix) + text;
  } catch (const std::bad_alloc&) {
    last_error = "out of memory";
  }
}

}  // namespace

OnProgress interrupt_function() {
  if (!interrupt.ask) return nullptr;
  return [](const emtr_progress&) {
    // Calls from within the interrupt ask nobody.
    struct Unasked {
      const Interrupt now = std::exchange(interrupt, {});
      ~Unasked() { interrupt = now; }
    } const unasked;
    return unasked.now.ask(unasked.now.user) != 0;
  };
}

OnProgress progress_function(emtr_progress_fn progress, void* user) {
  if (!progress) return interrupt_function();
  return [=](const emtr_progress& p) { return progress(&p, user) != 0; };
}

emtr_status guarded(void (*call)(const void* body), const void* body) noexcept {
  const DefaultArithmetic arithmetic;
  try {
    // A call from within a callback must not ask the token of the run that calls back.
    CancellationToken token(interrupt_function());
    const CancellationScope scope(interrupt.ask ? &token : nullptr);
    call(body);
    return EMTR_OK;
  } catch (const Error& error) {
    keep_message("", error.what());
    return error.status();
  } catch (const Cancelled&) {
    keep_message("", "interrupted");
    return EMTR_ERROR_INTERRUPTED;
  } catch (const std::bad_alloc&) {
    keep_message("", "out of memory");
    return EMTR_ERROR_MEMORY;
  } catch (const std::length_error&) {
    keep_message("", "out of memory");
    return EMTR_ERROR_MEMORY;
  } catch (const std::exception& error) {
    keep_message("unexpected: ", error.what());
    return EMTR_ERROR_INTERNAL;
  } catch (...) {
    keep_message("", "the progress function threw what is no std::exception");
    return EMTR_ERROR_INTERNAL;
  }
}

}  // namespace emtr

extern "C" {

const char* emtr_error_message(void) { return emtr::last_error.c_str(); }

void emtr_set_interrupt(emtr_interrupt_fn function, void* user) {
  emtr::interrupt = {function, user};
}

}  // extern "C"
