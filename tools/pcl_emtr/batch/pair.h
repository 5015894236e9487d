#pragma once

#include <emtr/emtr.h>

#include <cstddef>
#include <memory>
#include <string>

namespace cli {

/// What a pair is registered with. Pairs without settings of their own share one.
struct PairSettings {
  std::string preset;
  emtr_settings settings{};
  std::size_t mesh_points = 0;
};

/// One pair of many. The texts are the paths as the user wrote them.
struct Pair {
  std::size_t index = 0;
  std::string name;  // empty: none
  std::string source, target;
  std::string source_text, target_text;
  std::shared_ptr<const PairSettings> settings;
};

}  // namespace cli
