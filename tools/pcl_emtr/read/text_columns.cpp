#include "read/text_columns.h"

#include <algorithm>
#include <array>

#include "read/cloud_path.h"
#include "text/words.h"

namespace cli {
namespace {

constexpr std::string_view kBlanks = " \t\r\"'";

std::string_view trimmed(std::string_view cell) {
  const std::size_t begin = cell.find_first_not_of(kBlanks);
  if (begin == cell.npos) return "";
  return cell.substr(begin, cell.find_last_not_of(kBlanks) + 1 - begin);
}

/// Returns a column's name as a field: in lower case, normals as PCL calls them.
std::string field_name(const std::string& column) {
  std::string name = lower_case(column);
  for (char& c : name)
    if (c == ' ' || c == '\t') c = '_';
  if (name == "nx" || name == "ny" || name == "nz") return "normal_" + name.substr(1);
  return name;
}

std::string range(std::size_t first, std::size_t last) {
  return first == last ? "column " + std::to_string(first)
                       : "columns " + std::to_string(first) + " to " + std::to_string(last);
}

}  // namespace

void TextLine::decide(std::string_view line) {
  separator_ = line.find(';') != line.npos ? ';' : line.find(',') != line.npos ? ',' : '\0';
}

void TextLine::split(std::string_view line) {
  cells.clear();
  if (separator_ == 0) {
    cells = words_of(line);
    for (auto& cell : cells) cell = trimmed(cell);
    return;
  }
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(separator_, begin), line.size());
    cells.push_back(trimmed(line.substr(begin, end - begin)));
    begin = end + 1;
  }
  if (!cells.empty() && cells.back().empty()) cells.pop_back();  // a separator ends the line
}

bool is_comment(std::string_view line) {
  const std::size_t begin = std::min(line.find_first_not_of(" \t\r"), line.size());
  const std::string_view text = line.substr(begin);
  return !text.empty() &&
         (text[0] == '#' || text[0] == '%' || text[0] == '!' || text.substr(0, 2) == "//");
}

std::string_view without_mark(std::string_view line) {
  return line.substr(std::min(line.find_first_not_of(" \t\r#%!/"), line.size()));
}

TextColumns columns_of(const std::vector<std::string>& header, std::size_t count) {
  TextColumns out;
  std::vector<std::string> names;
  names.reserve(header.size());
  for (const auto& column : header) names.push_back(field_name(column));
  std::array<std::size_t, 3> place{};
  bool found = names.size() == count;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto at = std::find(names.begin(), names.end(), std::string(1, "xyz"[i]));
    found = found && at != names.end();
    place[i] = static_cast<std::size_t>(at - names.begin());
  }
  if (!found) place = {0, 1, 2};
  out.columns.assign(place.begin(), place.end());
  out.names = {"x", "y", "z"};
  if (!found) {
    if (count > 3)
      out.note = range(4, count) + " of it " + (count == 4 ? "is" : "are") +
                 " left out, no header line with x, y and z names " + (count == 4 ? "it" : "them");
    return out;
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (std::find(place.begin(), place.end(), i) != place.end()) continue;
    const bool twice = std::find(out.names.begin(), out.names.end(), names[i]) != out.names.end();
    if (twice || names[i].empty()) {
      out.note += (out.note.empty() ? "" : "; ") + range(i + 1, i + 1) +
                  " is left out, it has no name of its own";
      continue;
    }
    out.columns.push_back(i);
    out.names.push_back(names[i]);
  }
  return out;
}

}  // namespace cli
