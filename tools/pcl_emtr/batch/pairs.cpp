#include "batch/pairs.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "batch/csv.h"
#include "batch/pair_columns.h"
#include "failure.h"

namespace cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFiles[2] = {"source.ply", "target.ply"};  // of a folder that is a pair

std::shared_ptr<const PairSettings> common_settings(const Options& options) {
  auto settings = std::make_shared<PairSettings>();
  settings->preset = options.preset;
  settings->settings = options.settings;
  settings->mesh_points = options.mesh_points;
  return settings;
}

Pair row_pair(const CsvRow& row, const PairColumns& columns, const fs::path& folder,
              const std::shared_ptr<const PairSettings>& common, const Options& options) {
  Pair pair;
  pair.name = columns.name(row);
  pair.source_text = columns.source(row);
  pair.target_text = columns.target(row);
  pair.source = (folder / pair.source_text).string();
  pair.target = (folder / pair.target_text).string();
  pair.settings = columns.has_settings(row)
                      ? std::make_shared<PairSettings>(columns.settings(row, options, folder))
                      : common;
  return pair;
}

std::vector<Pair> table_pairs(const Options& options) {
  const std::string& path = options.batch.pairs;
  const std::vector<CsvRow> rows = read_csv(path);
  if (rows.empty()) throw FileFailure(path, "line 1: expected a column called source");
  const fs::path folder = fs::path(path).parent_path();
  const auto common = common_settings(options);
  std::vector<Pair> pairs;
  std::size_t line = rows[0].line;
  try {
    const PairColumns columns(rows[0].cells);
    for (std::size_t i = 1; i < rows.size(); ++i) {
      line = rows[i].line;
      pairs.push_back(row_pair(rows[i], columns, folder, common, options));
      pairs.back().index = i - 1;
    }
  } catch (const Failure& failure) {
    throw FileFailure(path, "line " + std::to_string(line) + ": " + failure.what());
  }
  return pairs;
}

std::vector<Pair> folder_pairs(const Options& options) {
  const fs::path top = options.batch.pairs;
  std::vector<std::string> names;
  const auto add = [&](const fs::path& folder) {
    if (fs::exists(folder / kFiles[0]) && fs::exists(folder / kFiles[1]))
      names.push_back(folder.lexically_relative(top).generic_string());
  };
  add(top);
  for (const auto& entry : fs::recursive_directory_iterator(top))
    if (entry.is_directory() && !entry.is_symlink()) add(entry.path());
  if (names.empty())
    throw FileFailure(options.batch.pairs,
                      std::string("no folder in it has ") + kFiles[0] + " and " + kFiles[1]);
  std::sort(names.begin(), names.end());
  const auto common = common_settings(options);
  std::vector<Pair> pairs;
  for (const std::string& name : names) {
    const bool itself = name == ".";
    Pair pair;
    pair.index = pairs.size();
    pair.name = itself ? fs::canonical(top).filename().string() : name;
    pair.source_text = itself ? kFiles[0] : name + "/" + kFiles[0];
    pair.target_text = itself ? kFiles[1] : name + "/" + kFiles[1];
    pair.source = (top / pair.source_text).string();
    pair.target = (top / pair.target_text).string();
    pair.settings = common;
    pairs.push_back(std::move(pair));
  }
  return pairs;
}

}  // namespace

std::vector<Pair> read_pairs(const Options& options) {
  return fs::is_directory(options.batch.pairs) ? folder_pairs(options) : table_pairs(options);
}

}  // namespace cli
