#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace cli {

/// Returns the text of --help: what most people need, on a screen of 80x24.
std::string short_help();

// The texts of --help-all above and below the options.
extern const char kDescription[];
std::string help_footer();

/// Formats --help-all like CLI11, with one empty line between groups of options rather than two.
class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_group(std::string group, bool is_positional,
                         std::vector<const CLI::Option*> options) const override {
    const std::string text = CLI::Formatter::make_group(group, is_positional, options);
    return is_positional || group == "Options" ? text : text.substr(1);
  }
};

}  // namespace cli
