#pragma once

#include <emtr/emtr.h>

#include <string>

#include "cloud_file.h"

namespace cli {

// Everything said to a person, in the look of PCL's tools. It all goes to standard error, so
// that standard output holds the matrix and nothing else.

/// Says nothing when quiet, but for warnings.
class Talk {
 public:
  explicit Talk(bool quiet) : quiet_(quiet) {}

  void loaded(const CloudFile& cloud) const;
  void registered(const emtr_result& result, const emtr_settings& settings) const;
  void verdict(const emtr_result& result) const;
  void saved(const std::string& path, const std::string& what) const;
  void warning(const std::string& text) const;

 private:
  void standing(const emtr_result& result) const;

  bool quiet_;
};

}  // namespace cli
