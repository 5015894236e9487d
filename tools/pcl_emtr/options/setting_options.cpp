#include "options/setting_options.h"

#include <algorithm>
#include <optional>

#include "failure.h"
#include "options/setting_text.h"
#include "options/suggestion.h"
#include "text/numbers.h"
#include "text/words.h"

namespace cli {
namespace {

std::optional<double> value_of(const emtr_setting_info& info, const std::string& text) {
  if (info.type == EMTR_SETTING_SWITCH) {
    if (text == "1" || text == "on") return 1;
    if (text == "0" || text == "off") return 0;
    return std::nullopt;
  }
  if (info.type == EMTR_SETTING_CHOICE) {
    const auto names = choices_of(info);
    const auto found = std::find(names.begin(), names.end(), text);
    if (found == names.end()) return std::nullopt;
    return static_cast<double>(found - names.begin());
  }
  const auto value = parse_real(text);
  const bool whole = info.type == EMTR_SETTING_INTEGER;
  if (!value || (whole && !parse_unsigned(text))) return std::nullopt;
  if (!(*value >= info.minimum && *value <= info.maximum)) return std::nullopt;
  return value;
}

std::string suggested(const emtr_setting_info& info, const std::string& text) {
  if (info.type == EMTR_SETTING_CHOICE) return did_you_mean(text, choices_of(info));
  if (info.type == EMTR_SETTING_SWITCH) return did_you_mean(text, {"on", "off"});
  return "";
}

}  // namespace

SettingOptions::SettingOptions(CLI::App& app) {
  for (std::size_t i = 0; i < emtr_setting_count(); ++i) {
    entries_.push_back(std::make_unique<Entry>());
    Entry& entry = *entries_.back();
    emtr_setting_describe(i, &entry.info, sizeof entry.info);
  }
  for (auto& entry : entries_) {
    const std::string name = entry->info.name;
    entry->option =
        app.add_option(option_name(name), entry->text, wrapped(description_of(entry->info)));
    entry->option->type_name(kind_of(entry->info));
    if (*entry->info.part) entry->option->group(group_of(entry->info.part));
  }
}

void SettingOptions::apply(emtr_settings& settings) const {
  for (const auto& entry : entries_) {
    if (entry->option->count() == 0) continue;
    const auto& info = entry->info;
    const UsageFailure wrong(option_name(info.name) + ": '" + entry->text + "' is not " +
                             expected(info) + suggested(info, entry->text));
    if (info.name == std::string("seed")) {  // a double would lose digits
      const auto seed = parse_unsigned(entry->text);
      if (!seed) throw wrong;
      settings.seed = *seed;
      continue;
    }
    const auto value = value_of(info, entry->text);
    if (!value) throw wrong;
    if (emtr_setting_set(&settings, info.name, *value) != EMTR_OK)
      throw UsageFailure(option_name(info.name) + ": " + emtr_error_message());
  }
}

void SettingOptions::use_reference(emtr_settings& settings) const {
  for (const auto& entry : entries_) {
    const std::string name = entry->info.name;
    const std::string choice = name == "neighbors" ? "kdtree" : name == "features" ? "pcl" : "";
    if (choice.empty()) continue;
    if (entry->option->count() > 0 && entry->text != choice)
      throw UsageFailure("--reference and " + option_name(name) + " " + entry->text +
                         " contradict each other, it means " + option_name(name) + " " + choice);
    emtr_setting_set(&settings, name.c_str(), value_of(entry->info, choice).value());
  }
}

}  // namespace cli
