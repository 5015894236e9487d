#include "read/text_reader.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <optional>

#include "failure.h"
#include "read/blob.h"
#include "read/text_columns.h"
#include "text/numbers.h"
#include "text/words.h"

namespace cli {
namespace {

bool is_letter(char c) {  // also of an alphabet beyond ASCII
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || static_cast<unsigned char>(c) > 127;
}

class TextTable {
 public:
  TextTable(CloudFile& cloud, std::uint64_t lines) : cloud_(cloud), lines_(lines) {}

  void add(std::string_view line) {
    ++line_;
    if (line.find('\0') != line.npos) fail("has a zero byte, which is no text");
    if (is_comment(line)) {
      if (!started_) remember(without_mark(line));
      return;
    }
    if (line.find_first_not_of(" \t\r") == line.npos) return;
    if (!started_) text_.decide(line);
    text_.split(line);
    if (is_count()) return;
    if (!started_ && is_header(line)) return;
    if (!started_) start();
    add_row();
  }

  /// Throws unless there are as many points as the file declares, if it does.
  void finish() {
    if (left_.value_or(0) > 0)
      throw FileFailure(cloud_.path, "truncated: " + std::to_string(*left_) +
                                         " points fewer than the number before them");
    if (!started_) cloud_.blob = doubles_blob({"x", "y", "z"});
    finish_blob(cloud_.blob, cloud_.path, "lines of x, y, z");
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw FileFailure(cloud_.path, "line " + std::to_string(line_) + " " + what);
  }

  /// Keeps what may be the names of the columns.
  void remember(std::string_view line) {
    TextLine names;
    names.decide(line);
    names.split(line);
    std::vector<std::string> header(names.cells.begin(), names.cells.end());
    const auto has = [&](const char* upper, const char* lower) {
      return std::any_of(header.begin(), header.end(),
                         [&](const auto& name) { return name == upper || name == lower; });
    };
    if (header_.empty() || (has("X", "x") && has("Y", "y") && has("Z", "z"))) header_ = header;
  }

  /// Takes a line of one whole number for the number of points that follow.
  bool is_count() {
    if (text_.cells.size() != 1 || left_.value_or(0) > 0) return false;
    if (started_ && !left_) return false;
    const auto count = parse_unsigned(text_.cells[0]);
    if (count) left_ = *count;
    return count.has_value();
  }

  /// Takes the first line for names when each cell of it has a letter and is no number.
  bool is_header(std::string_view line) {
    if (named_ || text_.cells.size() < 3) return false;
    for (const auto cell : text_.cells)
      if (parse_real(cell) || std::none_of(cell.begin(), cell.end(), is_letter)) return false;
    remember(line);
    named_ = true;
    return true;
  }

  void start() {
    started_ = true;
    count_ = text_.cells.size();
    if (count_ < 3)
      fail("has " + std::to_string(count_) + (count_ == 1 ? " value" : " values") +
           ", expected at least x, y and z");
    columns_ = columns_of(header_, count_);
    if (!columns_.note.empty()) cloud_.add_note(columns_.note);
    cloud_.blob = doubles_blob(columns_.names);
    values_.resize(columns_.columns.size());
    reserve_points(cloud_.blob, lines_);
  }

  void add_row() {
    auto& cells = text_.cells;
    if (left_ && *left_ == 0) fail("is a point more than the number before them says");
    if (left_) --*left_;
    if (cells.size() + 1 == count_ && text_.parted())
      cells.emplace_back();  // the last one is empty
    if (cells.size() != count_)
      fail("has " + std::to_string(cells.size()) + (cells.size() == 1 ? " value" : " values") +
           ", expected " + std::to_string(count_));
    for (std::size_t i = 0; i < values_.size(); ++i) {
      const auto cell = cells[columns_.columns[i]];
      const auto value = cell.empty() ? std::optional<double>(NAN) : parse_real(cell);
      if (!value) fail("has '" + shown(cell) + "', which is not a number");
      values_[i] = *value;
    }
    add_point(cloud_.blob, values_.data());
  }

  CloudFile& cloud_;
  std::uint64_t lines_;
  TextLine text_;
  std::vector<std::string> header_;
  TextColumns columns_;
  std::vector<double> values_;
  std::optional<std::uint64_t> left_;  // of the points that a number declares
  std::size_t count_ = 0;              // of columns
  std::uint64_t line_ = 0;
  bool started_ = false, named_ = false;
};

/// Counts the lines that are not empty, and goes back to the first one.
std::uint64_t count_lines(std::istream& in) {
  std::vector<char> block(1 << 16);
  std::uint64_t lines = 1;
  char before = '\n';
  while (in.read(block.data(), static_cast<std::streamsize>(block.size())) || in.gcount() > 0)
    for (std::streamsize i = 0; i < in.gcount(); ++i) {
      const char here = block[static_cast<std::size_t>(i)];
      lines += here == '\n' && before != '\n';
      before = here;
    }
  in.clear();
  in.seekg(0);
  return lines;
}

}  // namespace

void read_text(CloudFile& cloud) {
  std::ifstream in(cloud.place, std::ios::binary);
  TextTable table(cloud, count_lines(in));
  std::string line;
  bool first = true;
  while (std::getline(in, line)) {
    std::string_view text = line;
    if (first && text.substr(0, 3) == "\xEF\xBB\xBF") text.remove_prefix(3);
    first = false;
    table.add(text);
  }
  table.finish();
}

}  // namespace cli
