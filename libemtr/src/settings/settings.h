#pragma once

#include <emtr/emtr.h>

#include <cstddef>
#include <string>

namespace emtr {

using Settings = emtr_settings;

constexpr double kAnyRotation = 180;  ///< degrees: no limit of an angle
constexpr double kAnyTranslation = 1e12;    ///< of guess_translation: no limit

/// One row of the table of settings: the public description and where the field lies.
struct Setting {
  emtr_setting_info info;
  std::size_t offset;
  enum class Storage { Int32, Uint64, Double } storage;
};

std::size_t setting_count();
const Setting& setting(std::size_t index);
const Setting& find_setting(const std::string& name);  ///< throws Error when unknown

void set(Settings& settings, const std::string& name, double value);  ///< checks the range
double get(const Settings& settings, const Setting& setting);

/// Null past the last.
const char* preset_name(std::size_t index);

/// A preset's settings; throws Error when the name is unknown.
Settings preset(const std::string& name);

/// Throws Error on a value out of range, a contradiction or a guess that is no rigid motion.
void validate(const Settings& settings);

/// Whether what is off, auto or always by its setting is to be done; with auto, where `wanted`.
bool in_use(int setting, bool wanted);

/// Threads to use: the setting, or as many as OpenMP would by itself.
int thread_count(const Settings& settings);

}  // namespace emtr
