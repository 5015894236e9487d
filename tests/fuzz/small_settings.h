#pragma once

#include <emtr/emtr.h>

#include <algorithm>

#include "any_prior.h"
#include "calls.h"
#include "input.h"

namespace fuzz {

inline void limit(emtr_settings& settings, const char* name, double most) {
  double value = 0;
  require(accepted(emtr_setting_get(&settings, name, &value)));
  require(accepted(emtr_setting_set(&settings, name, std::min(value, most))));
}

/// Returns any preset with any changes; limits only those settings that cost time.
inline emtr_settings small_settings(Input& input) {
  emtr_settings settings;
  const char* preset = emtr_preset_name(input.ConsumeIntegralInRange<std::size_t>(0, 3));
  require(accepted(emtr_settings_init(&settings, sizeof settings, preset)));
  for (int n = input.ConsumeIntegralInRange(0, 6); n > 0; --n) {
    emtr_setting_info info;
    if (!accepted(emtr_setting_describe(input.ConsumeIntegral<std::uint8_t>(), &info, sizeof info)))
      continue;
    const double share = input.ConsumeProbability<double>();
    const double within = info.minimum + share * share * share * (info.maximum - info.minimum);
    const bool whole = info.type != EMTR_SETTING_REAL;
    accepted(emtr_setting_set(&settings, info.name, whole ? std::floor(within) : within));
  }
  settings.threads = 1;
  limit(settings, "population", 3);
  limit(settings, "iterations", 2);
  limit(settings, "complement_iterations", 2);
  limit(settings, "seeds", 4);
  limit(settings, "candidates", 3);
  limit(settings, "fallback_seeds", 4);
  limit(settings, "fallback_candidates", 3);
  // Tiny clouds have low confidence in every run, so that all of them would make the fallback
  // search, which costs as much as ten runs without it.
  if (!seldom(input)) settings.fallback_search = 0;
  // A depth map of what a sensor sees has a pixel for each leaf.
  settings.minimum_leaf_spacing = std::max(settings.minimum_leaf_spacing, 0.5);
  any_prior(input, settings);
  const auto place = [&](std::int32_t& known, double(&at)[3]) {
    if (!seldom(input)) return;
    known = 1;
    for (double& value : at) value = any_near(input, -4, 4);
  };
  place(settings.has_viewpoint_source, settings.viewpoint_source);
  place(settings.has_viewpoint_target, settings.viewpoint_target);
  return settings;
}

}  // namespace fuzz
