#pragma once

#include <emtr/emtr.h>

#include <CLI/CLI.hpp>
#include <string>

#include "options/numbers_option.h"

namespace cli {

/// The options that say where the sensors stood, or that the clouds' files say so.
class Viewpoints {
 public:
  explicit Viewpoints(CLI::App& app);

  /// Sets the positions that the user gave; throws UsageFailure for a word that is not a number.
  void apply(emtr_settings& settings) const;

  /// Tells whether the files provide the positions that the user does not give.
  bool from_files() const { return from_ == "file"; }

 private:
  NumbersOption<3> source_, target_;
  std::string from_ = "file";
};

}  // namespace cli
