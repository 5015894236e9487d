#pragma once

#include <emtr/emtr.h>

namespace cli {

/// Prints to standard error what the registration did: times, counts, costs and quality.
void print_summary(const emtr_result& result, const emtr_settings& settings);

}  // namespace cli
