#pragma once

#include <emtr/emtr.h>

#include <string>

#include "read/correspondence_file.h"
#include "read/user_fields.h"

namespace cli {

/// What the user asked for, checked. The paths of files that were not named are empty.
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
  bool viewpoints_from_files = true;  // for clouds without --viewpoint-source, --viewpoint-target
  bool residuals = false;             // of the source's points, in --aligned and --report
  bool quiet = false;
  emtr_settings settings{};
};

}  // namespace cli
