#include "options/setting_options.h"

#include "failure.h"
#include "options/setting_text.h"
#include "options/setting_value.h"
#include "text/words.h"

namespace cli {

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
    set_setting(settings, entry->info, entry->text, option_name(entry->info.name));
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
    set_setting(settings, entry->info, choice, option_name(name));
  }
}

}  // namespace cli
