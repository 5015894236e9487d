#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace cli {

/// Matches made elsewhere.
struct CorrespondenceFile {
  std::string path;                 // empty: none were given
  std::vector<std::int32_t> pairs;  // row of the source, row of the target; one pair after another
  std::vector<std::size_t> lines;   // where each pair stands, from 1

  std::size_t size() const { return lines.size(); }
};

/// Reads lines of two whole numbers, counted from 0; lines that begin with '#' and empty lines are
/// skipped. Throws FileFailure naming the line. Whether there are such points is the library's to
/// judge.
CorrespondenceFile read_correspondences(const std::string& path);

}  // namespace cli
