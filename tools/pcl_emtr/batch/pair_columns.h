#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "batch/csv.h"
#include "batch/pair.h"
#include "options/options.h"

namespace cli {

/// The columns of a table of pairs: source and target, perhaps name, and what a pair has of its
/// own: preset, mesh_points, guess (a file), source_viewpoint, target_viewpoint, axis,
/// translation_bounds, and any setting. A dash may stand for an underscore. An empty cell means
/// what all pairs have.
class PairColumns {
 public:
  /// Throws UsageFailure for names that are not known, missing or there twice.
  explicit PairColumns(const std::vector<std::string>& header);

  // These throw UsageFailure or FileFailure for what is wrong in a row.
  std::string source(const CsvRow& row) const { return file(row, "source"); }
  std::string target(const CsvRow& row) const { return file(row, "target"); }
  std::string name(const CsvRow& row) const;
  bool has_settings(const CsvRow& row) const;
  PairSettings settings(const CsvRow& row, const Options& options,
                        const std::filesystem::path& folder) const;

 private:
  std::string file(const CsvRow& row, const std::string& column) const;
  void require_length(const CsvRow& row) const;
  std::size_t place(const std::string& column) const;

  std::vector<std::string> names_;
};

}  // namespace cli
