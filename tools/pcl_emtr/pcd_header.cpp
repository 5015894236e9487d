#include "pcd_header.h"

#include <algorithm>
#include <array>

#include "failure.h"
#include "numbers.h"

namespace cli {
namespace {

/// The header's lines by their first word, up to and with DATA.
std::map<std::string, PcdHeader::Words> read_header(std::istream& in, const std::string& path) {
  static const std::array<std::string, 11> keywords = {"VERSION", "FIELDS",    "COLUMNS", "SIZE",
                                                       "TYPE",    "COUNT",     "WIDTH",   "HEIGHT",
                                                       "POINTS",  "VIEWPOINT", "DATA"};
  std::map<std::string, PcdHeader::Words> header;
  std::string line;
  while (!header.count("DATA") && std::getline(in, line)) {
    const auto words = words_of(line);
    if (words.empty() || words[0][0] == '#') continue;
    const std::string keyword(words[0]);
    if (in.eof() && !header.empty()) throw FileFailure(path, "truncated: ends in its PCD header");
    if (std::find(keywords.begin(), keywords.end(), keyword) == keywords.end())
      throw FileFailure(path, header.empty()
                                  ? "not a PCD file, expected a header that begins "
                                    "with '# .PCD' or 'VERSION'"
                                  : "its PCD header has an unknown line '" + shown(keyword) + "'");
    header[keyword] = PcdHeader::Words(words.begin() + 1, words.end());
  }
  if (header.empty()) throw FileFailure(path, "not a PCD file, it has no header");
  return header;
}

}  // namespace

PcdHeader::PcdHeader(std::istream& in, const std::string& path)
    : path_(path), lines_(read_header(in, path)) {}

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
