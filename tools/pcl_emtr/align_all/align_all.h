#pragma once

#include "options/options.h"

namespace cli {

/// Becomes pyemtr-align: the one beside this program, else the one in PATH, else the module of
/// python3. Returns only by a Failure, when none is installed.
[[noreturn]] void run_align_all(const Options& options);

}  // namespace cli
