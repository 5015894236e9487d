#pragma once

#include <CLI/CLI.hpp>

#include "options/options.h"

namespace cli {

/// The option --align-all, which aligns the scans of a folder.
class AlignOptions {
 public:
  AlignOptions(CLI::App& app, Options& options);

  /// Tells whether the user gave it. Then fills in what pyemtr-align gets; throws UsageFailure for
  /// options that it does not take.
  bool check(Options& options) const;

 private:
  CLI::App& app_;
};

}  // namespace cli
