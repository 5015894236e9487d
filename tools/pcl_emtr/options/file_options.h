#pragma once

#include <CLI/CLI.hpp>
#include <vector>

#include "options/options.h"

namespace cli {

/// The options that name files: clouds, output files, and the data that the user provides.
class FileOptions {
 public:
  /// Adds the options to `app`; their values go to `options`, which has to outlive the parsing.
  FileOptions(CLI::App& app, Options& options);

  /// Throws UsageFailure or FileFailure for paths and formats that cannot be meant; see
  /// check_file_names(). Sets what follows from what the user gave.
  void check(Options& options) const;

 private:
  void add_outputs(CLI::App& app, Options& options);
  void add_user_data(CLI::App& app, Options& options);
  void add_formats(CLI::App& app, Options& options);

  std::string mesh_points_;
  std::vector<CLI::Option*> inputs_;
  std::vector<CLI::Option*> outputs_;
};

}  // namespace cli
