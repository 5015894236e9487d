#pragma once

#include <optional>

#include "options/options.h"

namespace cli {

/// Reads the command line. Returns nothing when the user asked for help or the version, which is
/// printed to standard output. Throws UsageFailure or FileFailure.
std::optional<Options> parse_command_line(int argc, char** argv);

}  // namespace cli
