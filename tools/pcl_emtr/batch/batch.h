#pragma once

#include "options/options.h"

namespace cli {

/// Registers the pairs of --batch that --out has no record of, several at once, and returns the
/// exit code: 2 when a pair had an error, else 3 when one was not registered. Throws Failure.
int run_batch(const Options& options);

}  // namespace cli
