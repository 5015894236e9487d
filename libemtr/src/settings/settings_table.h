#pragma once

#include <utility>
#include <vector>

#include "settings/settings.h"

namespace emtr {

constexpr int kFewestPoints = 100;  ///< of both dense clouds together, whatever the search

/// Returns every setting that has a name, with its value in preset "default".
const std::vector<Setting>& setting_table();

struct Preset {
  const char* name;
  std::vector<std::pair<const char*, double>> changes;  ///< from the values of the table
};

const std::vector<Preset>& preset_table();

}  // namespace emtr
