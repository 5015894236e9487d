#include "settings/settings.h"

#include <omp.h>

#include <algorithm>
#include <cstring>

#include "settings/settings_table.h"
#include "settings/validation.h"
#include "util/error.h"

namespace emtr {
namespace {

void store(Settings& settings, const Setting& row, double value) {
  char* field = reinterpret_cast<char*>(&settings) + row.offset;
  switch (row.storage) {
    case Setting::Storage::Int32: {
      const auto v = static_cast<std::int32_t>(value);
      std::memcpy(field, &v, sizeof v);
      break;
    }
    case Setting::Storage::Uint64: {
      const auto v = static_cast<std::uint64_t>(value);
      std::memcpy(field, &v, sizeof v);
      break;
    }
    case Setting::Storage::Double:
      std::memcpy(field, &value, sizeof value);
      break;
  }
}

}  // namespace

std::size_t setting_count() { return setting_table().size(); }

const Setting& setting(std::size_t index) { return setting_table().at(index); }

const Setting& find_setting(const std::string& name) {
  for (const Setting& row : setting_table())
    if (name == row.info.name) return row;
  throw Error(EMTR_ERROR_SETTING, "there is no setting '" + name + "'");
}

void set(Settings& settings, const std::string& name, double value) {
  const Setting& row = find_setting(name);
  check_range(row.info, value);
  store(settings, row, value);
}

double get(const Settings& settings, const Setting& row) {
  const char* field = reinterpret_cast<const char*>(&settings) + row.offset;
  if (row.storage == Setting::Storage::Int32) {
    std::int32_t v;
    std::memcpy(&v, field, sizeof v);
    return v;
  }
  if (row.storage == Setting::Storage::Uint64) {
    std::uint64_t v;
    std::memcpy(&v, field, sizeof v);
    return static_cast<double>(v);
  }
  double v;
  std::memcpy(&v, field, sizeof v);
  return v;
}

const char* preset_name(std::size_t index) {
  return index < preset_table().size() ? preset_table()[index].name : nullptr;
}

Settings preset(const std::string& name) {
  std::string names;
  for (const Preset& preset : preset_table()) {
    if (name == preset.name) {
      Settings settings{};
      settings.size = sizeof settings;
      for (const Setting& row : setting_table()) store(settings, row, row.info.value);
      for (const auto& [setting, value] : preset.changes) set(settings, setting, value);
      return settings;
    }
    names += (names.empty() ? "" : ", ") + std::string(preset.name);
  }
  throw Error(EMTR_ERROR_SETTING, "there is no preset '" + name + "', expected one of " + names);
}

int thread_count(const Settings& settings) {
  if (settings.threads > 0) return settings.threads;
  // Inside a parallel region of the user's, each of its threads comes here with work of its own.
  if (omp_get_active_level() >= omp_get_max_active_levels()) return 1;
  return std::min(omp_get_max_threads(), kMaxThreads);
}

}  // namespace emtr
