#include "batch/pair_columns.h"

#include <emtr/emtr.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "failure.h"
#include "options/preset.h"
#include "options/setting_value.h"
#include "options/suggestion.h"
#include "read/matrix_file.h"
#include "text/numbers.h"
#include "text/words.h"

namespace cli {
namespace {

const std::vector<std::string> kHeading = {"source", "target", "name"};
const std::vector<std::string> kOthers = {
    "preset", "mesh_points",       "guess", "source_viewpoint", "target_viewpoint",
    "axis",   "translation_bounds"};

bool among(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string trimmed(const std::string& cell) {
  const auto words = words_of(cell);
  if (words.empty()) return "";
  const char* begin = words.front().data();
  const char* end = words.back().data() + words.back().size();
  return {begin, end};
}

std::optional<emtr_setting_info> find_setting(const std::string& name) {
  for (std::size_t i = 0; i < emtr_setting_count(); ++i) {
    emtr_setting_info info;
    emtr_setting_describe(i, &info, sizeof info);
    if (name == info.name) return info;
  }
  return std::nullopt;
}

std::vector<std::string> known_columns() {
  std::vector<std::string> names = kHeading;
  names.insert(names.end(), kOthers.begin(), kOthers.end());
  for (std::size_t i = 0; i < emtr_setting_count(); ++i) {
    emtr_setting_info info;
    emtr_setting_describe(i, &info, sizeof info);
    names.emplace_back(info.name);
  }
  return names;
}

void read_numbers(const std::string& column, const std::string& cell, double* numbers,
                  std::size_t count) {
  const auto words = words_of(cell);
  bool good = words.size() == count;
  for (std::size_t i = 0; good && i < count; ++i) {
    const auto value = parse_real(words[i]);
    good = value && std::isfinite(*value);
    if (good) numbers[i] = *value;
  }
  if (!good)
    throw UsageFailure(column + ": expected " + std::to_string(count) +
                       " numbers with blanks between, got '" + cell + "'");
}

void set_cell(PairSettings& pair, const std::string& column, const std::string& cell,
              const std::filesystem::path& folder) {
  emtr_settings& s = pair.settings;
  if (column == "preset") return;  // it comes first, see settings()
  if (column == "mesh_points") {
    const auto count = parse_unsigned(cell);
    if (!count || *count > 100000000)
      throw UsageFailure("mesh_points: '" + cell + "' is not a whole number up to 100000000");
    pair.mesh_points = *count;
  } else if (column == "guess") {
    read_matrix((folder / cell).string(), s.guess);
    s.has_guess = 1;
  } else if (column == "source_viewpoint") {
    read_numbers(column, cell, s.viewpoint_source, 3);
    s.has_viewpoint_source = 1;
  } else if (column == "target_viewpoint") {
    read_numbers(column, cell, s.viewpoint_target, 3);
    s.has_viewpoint_target = 1;
  } else if (column == "axis") {
    read_numbers(column, cell, s.axis, 3);
    s.has_axis = 1;
  } else if (column == "translation_bounds") {
    double bounds[6];
    read_numbers(column, cell, bounds, 6);
    std::copy_n(bounds, 3, s.translation_minimum);
    std::copy_n(bounds + 3, 3, s.translation_maximum);
    s.has_translation_bounds = 1;
  } else {
    set_setting(s, *find_setting(column), cell, column);
  }
}

}  // namespace

PairColumns::PairColumns(const std::vector<std::string>& header) {
  for (const std::string& cell : header) {
    std::string name = trimmed(cell);
    std::replace(name.begin(), name.end(), '-', '_');
    if (among(names_, name)) throw UsageFailure("two columns are called " + name);
    if (!among(kHeading, name) && !among(kOthers, name) && !find_setting(name))
      throw UsageFailure("'" + shown(name) + "' is no column and no setting" +
                         did_you_mean(name, known_columns()));
    names_.push_back(name);
  }
  for (const char* needed : {"source", "target"})
    if (!among(names_, needed))
      throw UsageFailure(std::string("expected a column called ") + needed);
}

std::size_t PairColumns::place(const std::string& column) const {
  return static_cast<std::size_t>(std::find(names_.begin(), names_.end(), column) - names_.begin());
}

void PairColumns::require_length(const CsvRow& row) const {
  if (row.cells.size() != names_.size())
    throw UsageFailure("expected " + std::to_string(names_.size()) + " cells, got " +
                       std::to_string(row.cells.size()));
}

std::string PairColumns::file(const CsvRow& row, const std::string& column) const {
  require_length(row);
  const std::string& cell = row.cells[place(column)];
  if (cell.empty()) throw UsageFailure(column + ": expected a file, got nothing");
  return cell;
}

std::string PairColumns::name(const CsvRow& row) const {
  require_length(row);
  return among(names_, "name") ? row.cells[place("name")] : "";
}

bool PairColumns::has_settings(const CsvRow& row) const {
  for (std::size_t i = 0; i < names_.size(); ++i)
    if (!among(kHeading, names_[i]) && !trimmed(row.cells[i]).empty()) return true;
  return false;
}

PairSettings PairColumns::settings(const CsvRow& row, const Options& options,
                                   const std::filesystem::path& folder) const {
  PairSettings pair;
  pair.preset = options.preset;
  pair.mesh_points = options.mesh_points;
  if (among(names_, "preset"))
    if (const std::string preset = trimmed(row.cells[place("preset")]); !preset.empty())
      pair.preset = preset;
  const auto found = options.batch.by_preset.find(pair.preset);
  if (found == options.batch.by_preset.end())
    throw UsageFailure("preset: '" + shown(pair.preset) + "' is not one of: " + preset_names() +
                       did_you_mean(pair.preset, presets()));
  pair.settings = found->second;
  for (std::size_t i = 0; i < names_.size(); ++i) {
    const std::string cell = trimmed(row.cells[i]);
    if (!among(kHeading, names_[i]) && !cell.empty()) set_cell(pair, names_[i], cell, folder);
  }
  return pair;
}

}  // namespace cli
