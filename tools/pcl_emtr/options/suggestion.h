#pragma once

#include <string>
#include <vector>

namespace cli {

/// Returns "; did you mean X?" where X is the known word nearest to a mistyped one, or "" when none
/// is near. Leading dashes do not count.
std::string did_you_mean(const std::string& word, const std::vector<std::string>& known);

}  // namespace cli
