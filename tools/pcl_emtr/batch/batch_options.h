#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "options/options.h"

namespace cli {

/// The options of a run over many pairs.
class BatchOptions {
 public:
  /// Adds the options to `app`, which has those of the clouds; their values go to `options`, and
  /// both have to outlive the parsing.
  BatchOptions(CLI::App& app, Options& options);

  /// Throws UsageFailure for options that belong to one pair, or to many, where the other is
  /// wanted. Sets one thread for each registration unless the user gave a number.
  void check(Options& options) const;

 private:
  CLI::App& app_;
  std::string workers_, memory_;
};

}  // namespace cli
