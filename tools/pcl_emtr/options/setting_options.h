#pragma once

#include <emtr/emtr.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

namespace cli {

/// One option for each setting of the library: --dense-points for dense_points. Name, group, range
/// and default in --help-all come from the library's own description.
class SettingOptions {
 public:
  explicit SettingOptions(CLI::App& app);

  /// Sets what the user gave; throws UsageFailure for a value of the wrong kind or out of range.
  void apply(emtr_settings& settings) const;

  /// Lets PCL answer nearest-neighbor queries and compute features; throws UsageFailure when the
  /// user chose otherwise.
  void use_reference(emtr_settings& settings) const;

 private:
  struct Entry {
    emtr_setting_info info;
    CLI::Option* option;
    std::string text;
  };
  std::vector<std::unique_ptr<Entry>> entries_;  // CLI11 keeps references to the texts
};

}  // namespace cli
