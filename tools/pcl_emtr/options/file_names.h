#pragma once

#include <string>
#include <vector>

namespace cli {

struct NamedFile {
  std::string option;  // its name on the command line
  std::string path;
};

/// Throws UsageFailure or FileFailure for paths that cannot be meant: an empty one, an option taken
/// for a file, one file for two purposes, a cloud's extension for a text file or the reverse.
/// `aligned_format` is the format that the user named for --aligned, or empty.
void check_file_names(const std::vector<NamedFile>& inputs, const std::vector<NamedFile>& outputs,
                      const std::string& aligned_format);

}  // namespace cli
