#pragma once

#include <vector>

#include "batch/pair.h"
#include "options/options.h"

namespace cli {

/// Reads the CSV file of --batch, or finds the pairs of its folder. Throws FileFailure that names
/// the line, for all that can be known without the clouds.
std::vector<Pair> read_pairs(const Options& options);

}  // namespace cli
