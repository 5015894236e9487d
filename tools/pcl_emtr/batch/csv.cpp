#include "batch/csv.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string_view>
#include <utility>

#include "failure.h"

namespace cli {
namespace {

std::string content(const std::string& path) {
  if (std::filesystem::is_directory(path))
    throw FileFailure(path, "is a directory, expected a CSV file");
  std::ifstream in(path, std::ios::binary);
  if (!in) throw FileFailure(path, std::strerror(errno));
  std::ostringstream all;
  all << in.rdbuf();
  if (in.bad()) throw FileFailure(path, "cannot be read to its end");
  return all.str();
}

/// Takes rows off the front of a text.
class Parser {
 public:
  Parser(const std::string& path, std::string_view text) : path_(path), text_(text) {}

  bool done() const { return at_ == text_.size(); }

  CsvRow row() {
    CsvRow row{line_, {}};
    do row.cells.push_back(cell());
    while (take(','));
    take('\r');
    if (!done() && !take('\n')) fail("a quoted cell does not end where its quotes do");
    row.line = line_;
    ++line_;
    if (row.cells.size() == 1 && row.cells[0].empty() && !quoted_) row.cells.clear();
    return row;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw FileFailure(path_, "line " + std::to_string(line_) + ": " + what);
  }

  bool take(char wanted) {
    if (done() || text_[at_] != wanted) return false;
    ++at_;
    return true;
  }

  std::string cell() {
    quoted_ = take('"');
    return quoted_ ? quoted() : plain();
  }

  std::string plain() {
    std::size_t end = std::min(text_.find_first_of(",\n", at_), text_.size());
    const bool line_ends = end == text_.size() || text_[end] == '\n';
    const std::size_t begin = at_;
    at_ = end;
    if (line_ends && end > begin && text_[end - 1] == '\r') at_ = --end;
    return std::string(text_.substr(begin, end - begin));
  }

  std::string quoted() {
    std::string cell;
    const std::size_t begin = line_;
    for (;;) {
      if (done()) {
        line_ = begin;
        fail("the quotes of a cell do not end");
      }
      const char c = text_[at_++];
      if (c == '\n') ++line_;
      if (c == '"' && !take('"')) return cell;
      cell += c;
    }
  }

  const std::string& path_;
  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
  bool quoted_ = false;
};

}  // namespace

std::vector<CsvRow> read_csv(const std::string& path) {
  const std::string text = content(path);
  constexpr std::string_view mark = "\xef\xbb\xbf";
  std::string_view rest = text;
  if (rest.substr(0, mark.size()) == mark) rest.remove_prefix(mark.size());
  std::vector<CsvRow> rows;
  for (Parser parser(path, rest); !parser.done();) {
    CsvRow row = parser.row();
    if (!row.cells.empty()) rows.push_back(std::move(row));
  }
  return rows;
}

std::string csv_line(const std::vector<std::string>& cells) {
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (i > 0) line += ',';
    if (cells[i].find_first_of(",\"\r\n") == std::string::npos) {
      line += cells[i];
      continue;
    }
    line += '"';
    for (const char c : cells[i]) line += c == '"' ? std::string("\"\"") : std::string(1, c);
    line += '"';
  }
  return line + "\n";
}

}  // namespace cli
