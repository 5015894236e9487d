#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace cli {

/// Splits the lines of a text table. The first line of numbers decides what parts the columns: a
/// semicolon, else a comma, else blanks and tabs.
class TextLine {
 public:
  /// Splits a line into `cells`, without blanks and quotes around them.
  void split(std::string_view line);

  /// Lets `line` decide what parts the columns from here on.
  void decide(std::string_view line);

  /// Tells whether the columns are parted by a character, so that a cell may be empty.
  bool parted() const { return separator_ != 0; }

  std::vector<std::string_view> cells;

 private:
  char separator_ = 0;  // 0: blanks and tabs
};

/// Tells whether the line is a comment: it begins with #, //, % or !.
bool is_comment(std::string_view line);

/// Returns the words behind the mark of a comment, or the whole line when it is none.
std::string_view without_mark(std::string_view line);

/// Which columns of a text table are taken, and what they are called.
struct TextColumns {
  std::vector<std::size_t> columns;  // x, y, z, and then the other fields
  std::vector<std::string> names;    // of the fields
  std::string note;                  // what is left out, or taken without a name; or empty
};

/// Returns the columns of a table of `count` columns by the names in its header line. Without a
/// header that has x, y and z, the first three columns are taken and the others left out.
TextColumns columns_of(const std::vector<std::string>& header, std::size_t count);

}  // namespace cli
