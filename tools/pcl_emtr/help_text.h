#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace cli {

extern const char kDescription[];
extern const char kFooter[];

/// CLI11's, with one empty line between groups of settings rather than two.
class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_group(std::string group, bool is_positional,
                         std::vector<const CLI::Option*> options) const override {
    const std::string text = CLI::Formatter::make_group(group, is_positional, options);
    return group.compare(0, 8, "Settings") == 0 ? text.substr(1) : text;
  }
};

}  // namespace cli
