#include "read/pcd_header.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "failure.h"
#include "text/numbers.h"
#include "text/words.h"

namespace cli {
namespace {

constexpr std::array<const char*, 11> kKeywords = {"VERSION", "FIELDS", "COLUMNS",  "SIZE",
                                                   "TYPE",    "COUNT",  "WIDTH",    "HEIGHT",
                                                   "POINTS",  "DATA",   "VIEWPOINT"};

/// Returns the header's lines by their first word; DATA is the last one.
std::map<std::string, PcdHeader::Words> read_header(std::istream& in, const std::string& path) {
  std::map<std::string, PcdHeader::Words> header;
  std::string line;
  while (!header.count("DATA") && std::getline(in, line)) {
    const auto words = words_of(line);
    if (words.empty() && !line.empty())
      throw FileFailure(path, "its PCD header has a line of blanks, at which PCL would end it");
    if (words.empty() || words[0][0] == '#') continue;
    const std::string keyword(words[0]);
    if (in.eof() && !header.empty()) throw FileFailure(path, "truncated: ends in its PCD header");
    if (std::find(kKeywords.begin(), kKeywords.end(), keyword) == kKeywords.end())
      throw FileFailure(path, header.empty()
                                  ? "not a PCD file, expected a header that begins "
                                    "with '# .PCD' or 'VERSION'"
                                  : "its PCD header has an unknown line '" + shown(keyword) + "'");
    // PCL takes both names for one list, and takes over each one of several lines.
    const bool columns = keyword == "COLUMNS" || keyword == "FIELDS";
    if (header.count(keyword) || (columns && (header.count("COLUMNS") || header.count("FIELDS"))))
      throw FileFailure(path, "its PCD header has a second line '" + keyword + "'");
    header[keyword] = PcdHeader::Words(words.begin() + 1, words.end());
  }
  if (header.empty()) throw FileFailure(path, "not a PCD file, it has no header");
  return header;
}

}  // namespace

PcdHeader::PcdHeader(std::istream& in, const std::string& path)
    : path_(path), lines_(read_header(in, path)) {}

void PcdHeader::require_end(std::istream& in) const {
  const auto start = in.tellg();
  std::string line;
  std::size_t begin = line.npos;
  while ((begin == line.npos || line[begin] == '#') && std::getline(in, line))
    begin = line.find_first_not_of(" \t\r\v\f");
  begin = std::min(begin, line.size());
  for (const std::string keyword : kKeywords)
    if (line.compare(begin, keyword.size(), keyword) == 0)
      throw FileFailure(path_, "damaged: its points begin with a line '" + keyword +
                                   "', which PCL would take for one of the header");
  in.clear();
  in.seekg(start);
}

const PcdHeader::Words& PcdHeader::words(const std::string& key) const {
  if (!has(key) || lines_.at(key).empty())
    throw FileFailure(path_, "its PCD header has no " + key + " (truncated?)");
  return lines_.at(key);
}

std::uint64_t PcdHeader::whole(const std::string& key, const std::string& word) const {
  const auto value = parse_unsigned(word);
  if (!value || *value > 0xffffffffu)
    throw FileFailure(path_, "its PCD header has " + key + " '" + shown(word) +
                                 "', expected a whole number from 0 to 4294967295");
  return *value;
}

std::optional<std::array<double, 7>> PcdHeader::viewpoint() const {
  if (!has("VIEWPOINT")) return std::nullopt;
  const Words& found = words("VIEWPOINT");
  std::array<double, 7> values{};
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto value = i < found.size() ? parse_real(found[i]) : std::nullopt;
    if (!value || found.size() != values.size())
      throw FileFailure(path_, "its PCD header has a VIEWPOINT that is not 7 numbers");
    values[i] = *value;
  }
  return values;
}

}  // namespace cli
