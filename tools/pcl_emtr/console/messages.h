#pragma once

#include <emtr/emtr.h>

#include <string>

#include "read/cloud_file.h"

namespace cli {

/// Prints messages for people, in the style of PCL's tools. They go to standard error, so that
/// standard output has the matrix and nothing else. When quiet, prints warnings only.
class Messages {
 public:
  explicit Messages(bool quiet) : quiet_(quiet) {}

  void loaded(const CloudFile& cloud) const;
  void registered(const emtr_result& result, const emtr_settings& settings) const;
  void verdict(const emtr_result& result) const;
  void saved(const std::string& path, const std::string& what) const;
  void warning(const std::string& text) const;

 private:
  bool quiet_;
};

}  // namespace cli
