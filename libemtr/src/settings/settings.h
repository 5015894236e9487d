#pragma once

#include <emtr/emtr.h>

#include <cstddef>
#include <string>

#include "settings/choices.h"

namespace emtr {

using Settings = emtr_settings;

constexpr int kMaxThreads = 1024;
constexpr double kAnyRotation = 180;      ///< degrees: the value that limits no angle
constexpr double kAnyTranslation = 1e12;  ///< the value of guess_translation that limits nothing

/// A row of the table of settings: the public description, and where the struct stores the field.
struct Setting {
  emtr_setting_info info;
  std::size_t offset;
  enum class Storage { Int32, Uint64, Double } storage;
};

std::size_t setting_count();
const Setting& setting(std::size_t index);

/// Returns the row of a setting; throws Error when there is none of that name.
const Setting& find_setting(const std::string& name);

/// Sets a setting by name; throws Error when the value is out of its range.
void set(Settings& settings, const std::string& name, double value);

double get(const Settings& settings, const Setting& setting);

/// Returns the names of the presets by index, null past the last.
const char* preset_name(std::size_t index);

/// Returns the settings of a preset; throws Error when there is none of that name.
Settings preset(const std::string& name);

/// Returns how many threads to use: the setting, or as many as OpenMP would by itself, which is one
/// inside an active parallel region unless nested ones are allowed.
int thread_count(const Settings& settings);

}  // namespace emtr
