#pragma once

#include <emtr/emtr.h>

#include <map>
#include <string>
#include <vector>

#include "formats/format.h"
#include "read/correspondence_file.h"
#include "read/user_fields.h"

namespace cli {

/// Many pairs in one run, with --batch. Then the settings of the options are those of pairs that
/// have none of their own.
struct BatchInput {
  std::string pairs;  // a CSV file or a folder of pairs; empty: one pair
  std::string out;    // the folder of the results
  std::size_t workers = 0;
  std::size_t cache_bytes = 0;  // of preprocessed clouds
  bool retry_errors = false;
  std::map<std::string, emtr_settings> by_preset;  // with what the user gave on top
};

/// Many scans of one thing, with --align-all.
struct AlignInput {
  std::string scans;                   // a folder; empty: one pair, or --batch
  std::vector<std::string> arguments;  // that pyemtr-align gets beside it
};

/// What the user asked for, checked. The paths of files that were not named are empty.
struct Options {
  std::string source;
  std::string target;
  std::string output;   // the matrix; empty: standard output
  std::string aligned;  // the moved source
  std::string report;
  std::string html;       // the page to look at
  std::string html_unit;  // the name of the clouds' unit on it
  std::string guess;
  std::string input_format;            // of both clouds; empty: by extension or beginning
  std::string aligned_format;          // of --aligned; empty: by extension
  const Format* aligned_as = nullptr;  // the format of --aligned, once the source is read
  std::size_t mesh_points = 0;         // that sample each mesh; 0: its vertices
  UserFields fields;
  CorrespondenceFile correspondences;
  std::string preset = "default";
  bool viewpoints_from_files = true;  // for clouds without --viewpoint-source, --viewpoint-target
  bool residuals = false;             // of the source's points, in --aligned and --report
  bool quiet = false;
  emtr_settings settings{};
  BatchInput batch;
  AlignInput align;
};

}  // namespace cli
