#include "settings/settings.h"

#include <omp.h>

#include <cmath>
#include <cstring>
#include <locale>
#include <sstream>
#include <vector>

#include "util/error.h"
#include "priors/make_prior.h"
#include "geometry/rigid.h"
#include "settings/settings_table.h"

namespace emtr {
namespace {

constexpr auto Real = EMTR_SETTING_REAL;
constexpr auto Switch = EMTR_SETTING_SWITCH;

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

void check_range(const emtr_setting_info& info, double value) {
  const bool whole = info.type == Real || value == std::floor(value);
  if (value >= info.minimum && value <= info.maximum && whole) return;  // false for NaN
  std::ostringstream message;
  message.imbue(std::locale::classic());
  message.precision(17);
  message << "setting '" << info.name << "' is " << value << ", expected ";
  if (info.type == Switch)
    message << "0 or 1";
  else
    message << (info.type == Real ? "a number" : "a whole number") << " from " << info.minimum
            << " to " << info.maximum;
  throw Error(EMTR_ERROR_SETTING, message.str());
}

void require(bool holds, const char* message) {
  if (!holds) throw Error(EMTR_ERROR_SETTING, message);
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

void validate(const Settings& settings) {
  for (const Setting& row : setting_table())
    if (row.storage != Setting::Storage::Uint64) check_range(row.info, get(settings, row));
  require(settings.sparse_points < settings.dense_points,
          "settings 'sparse_points' and 'dense_points' contradict each other: the sparse source "
          "cloud must have fewer points than both dense clouds together");
  require(settings.normal_radius <= settings.feature_radius,
          "settings 'normal_radius' and 'feature_radius' contradict each other: a feature's "
          "neighborhood must not be smaller than a normal's");
  require(settings.complement_scale_end <= settings.complement_scale_start,
          "settings 'complement_scale_end' and 'complement_scale_start' contradict each other: "
          "the scale must not grow");
  require(!settings.has_guess || is_rigid(settings.guess),
          "setting 'guess' is not a rigid transformation: expected a row-major 4x4 of a rotation, "
          "a translation and (0, 0, 0, 1)");
  const auto finite = [](const double* v) {
    return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
  };
  require(!settings.has_viewpoint_source || finite(settings.viewpoint_source),
          "setting 'viewpoint_source' is not finite: expected a sensor position x, y, z");
  require(!settings.has_viewpoint_target || finite(settings.viewpoint_target),
          "setting 'viewpoint_target' is not finite: expected a sensor position x, y, z");
  validate_priors(settings);
}

bool in_use(int setting, bool wanted) {
  enum { Off, Auto, Always };
  return setting == Always || (setting == Auto && wanted);
}

int thread_count(const Settings& settings) {
  if (settings.threads > 0) return settings.threads;
  // In a parallel region of the caller's, each of its threads comes here with work of its own.
  return omp_get_active_level() < omp_get_max_active_levels() ? omp_get_max_threads() : 1;
}

}  // namespace emtr
