#include "batch/table.h"

#include <filesystem>
#include <string>
#include <vector>

#include "batch/csv.h"
#include "write/output_files.h"

namespace cli {
namespace {

const std::vector<std::string> kPlain = {"index",  "name",   "source",    "target",
                                         "status", "reason", "confidence"};
const std::vector<std::string> kQuality = {"overlap_source", "overlap_target", "inlier_rmse"};

std::string cell(const Json& value) {
  if (value.is_null()) return "";
  return value.is_string() ? value.get<std::string>() : value.dump();
}

std::string cell(const Json& group, const std::string& name) {
  return group.is_object() && group.contains(name) ? cell(group[name]) : "";
}

std::string heading() {
  std::vector<std::string> names = kPlain;
  names.insert(names.end(), kQuality.begin(), kQuality.end());
  names.insert(names.end(), {"seconds", "error"});
  for (int i = 0; i < 16; ++i) names.push_back("t" + std::to_string(i / 4) + std::to_string(i % 4));
  return csv_line(names);
}

std::string line(const Json& record) {
  const auto group = [&](const char* name) {
    return record.contains(name) ? record[name] : Json();
  };
  std::vector<std::string> cells;
  cells.reserve(kPlain.size() + kQuality.size() + 2 + 16);
  for (const auto& name : kPlain) cells.push_back(cell(record, name));
  for (const auto& name : kQuality) cells.push_back(cell(group("quality"), name));
  cells.push_back(cell(group("seconds"), "total"));
  cells.push_back(cell(record, "error"));
  const Json pose = group("transformation");
  for (std::size_t i = 0; i < 16; ++i)
    cells.push_back(pose.is_array() ? cell(pose[i / 4][i % 4]) : "");
  return csv_line(cells);
}

}  // namespace

void write_table(const RecordFile& records) {
  std::string text = heading();
  records.for_each([&](const Json& record) { text += line(record); });
  OutputFiles files;
  files.write_text((std::filesystem::path(records.folder()) / "results.csv").string(), text);
  files.commit();
}

}  // namespace cli
