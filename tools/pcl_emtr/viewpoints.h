#pragma once

#include <emtr/emtr.h>

#include <CLI/CLI.hpp>
#include <array>
#include <string>

#include "cloud_file.h"

namespace cli {

/// Where the sensors stood: given on the command line, else taken from the clouds' files.
class Viewpoints {
 public:
  explicit Viewpoints(CLI::App& app);

  /// Sets the positions that the user gave; throws UsageFailure for what is no position.
  void apply(emtr_settings& settings) const;

  /// Whether positions that are not given are taken from the files.
  bool from_files() const { return from_ == "file"; }

 private:
  struct Entry {
    CLI::Option* option;
    std::array<std::string, 3> words;  // as texts, because CLI11 reads numbers by the locale
  };
  Entry source_, target_;
  std::string from_ = "file";
};

/// Brings a cloud and its setting together: a position that was given becomes the cloud's, so that
/// it moves along with it; else one that the file has becomes the setting if `from_file`.
void settle_viewpoint(CloudFile& cloud, bool from_file, std::int32_t& known, double (&position)[3]);

}  // namespace cli
