#pragma once

#include <string>
#include <vector>

namespace cli {

struct NamedFile {
  std::string option;  // what it is called on the command line
  std::string path;
};

/// Throws UsageFailure or FileFailure for names that cannot be meant: empty ones, an option taken
/// for a file, one file for two purposes, a cloud's extension for a text or the reverse.
void check_file_names(const std::vector<NamedFile>& inputs, const std::vector<NamedFile>& outputs);

}  // namespace cli
