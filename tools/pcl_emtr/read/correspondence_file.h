#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace cli {

/// Correspondences that the user provides.
struct CorrespondenceFile {
  std::string path;                 // empty: none were given
  std::vector<std::int32_t> pairs;  // source row, target row, source row, ...
  std::vector<std::size_t> lines;   // the line of each pair, counted from 1

  std::size_t size() const { return lines.size(); }
};

/// Reads lines of two point numbers, counted from 0; skips empty lines and lines that begin with
/// '#'. Throws FileFailure that names the line. The library checks that the points exist.
CorrespondenceFile read_correspondences(const std::string& path);

}  // namespace cli
