#pragma once

#include "options/options.h"

namespace cli {

/// Throws a Failure when the pages of a batch are wanted and the Python package that makes them is
/// not installed, before anything is registered.
void require_pages(const Options& options);

/// Has the Python package make the pages of the recorded pairs and their index. Returns its exit
/// code: 0, or that of input and output when a page could not be made.
int make_pages(const Options& options);

}  // namespace cli
