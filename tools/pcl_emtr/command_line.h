#pragma once

#include <emtr/emtr.h>

#include <optional>
#include <string>

#include "correspondence_file.h"
#include "user_fields.h"

namespace cli {

/// What the user asked for, checked. Files that were not named are empty.
struct Options {
  std::string source;
  std::string target;
  std::string output;   // the matrix; empty: standard output
  std::string aligned;  // the moved source
  std::string report;
  std::string guess;
  UserFields fields;
  CorrespondenceFile correspondences;
  std::string preset = "default";
  bool viewpoints_from_files = true;  // of the clouds for which none was given
  bool residuals = false;             // of the source's points, in --aligned and --report
  bool quiet = false;
  emtr_settings settings{};
};

/// Nothing when --help or --version was asked for, which is printed to standard output.
/// Throws UsageFailure or FileFailure.
std::optional<Options> parse_command_line(int argc, char** argv);

}  // namespace cli
