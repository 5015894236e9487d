#include "formats/beginning.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace cli {
namespace {

bool is(std::string_view bytes, std::string_view begin) {
  return bytes.substr(0, begin.size()) == begin;
}

/// Returns the first word behind empty lines and comments, or "" where there is none or no text.
std::string_view first_word(std::string_view bytes) {
  constexpr std::string_view blanks = " \t\r\n";
  if (!begins_text(bytes)) return "";
  for (std::size_t at = bytes.find_first_not_of(blanks); at != bytes.npos;) {
    if (bytes[at] != '#') {
      const std::size_t end = std::min(bytes.find_first_of(blanks, at), bytes.size());
      return bytes.substr(at, end - at);
    }
    at = bytes.find('\n', at);
    if (at != bytes.npos) at = bytes.find_first_not_of(blanks, at);
  }
  return "";
}

template <std::size_t Size>
bool is_one_of(std::string_view word, const std::array<std::string_view, Size>& words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

}  // namespace

bool begins_pcd(std::string_view bytes) {
  constexpr std::array<std::string_view, 4> words = {"VERSION", "FIELDS", "COLUMNS", "SIZE"};
  // The points of a binary file may follow, which are no text.
  return is(bytes, "# .PCD") || is_one_of(first_word(bytes.substr(0, bytes.find('\0'))), words);
}

bool begins_ply(std::string_view bytes) { return is(bytes, "ply\n") || is(bytes, "ply\r"); }

bool begins_obj(std::string_view bytes) {
  constexpr std::array<std::string_view, 8> words = {"v", "vn", "vt", "f", "g", "o", "s", "usemtl"};
  const std::string_view word = first_word(bytes);
  return word == "mtllib" || is_one_of(word, words);
}

bool begins_stl(std::string_view bytes) {
  if (first_word(bytes) == "solid") return true;
  if (bytes.size() < 84 || begins_text(bytes)) return false;
  std::uint64_t triangles = 0;  // behind 80 bytes of any text
  for (std::size_t i = 4; i-- > 0;)
    triangles = triangles << 8 | static_cast<unsigned char>(bytes[80 + i]);
  return triangles > 0 && 84 + 50 * triangles >= bytes.size();
}

bool begins_off(std::string_view bytes) {
  const std::string_view word = first_word(bytes);
  const std::size_t end = word.find("OFF");
  return end != word.npos && word.find_first_not_of("STCN4n") >= end;
}

bool begins_npy(std::string_view bytes) { return is(bytes, "\x93NUMPY"); }

bool begins_las(std::string_view bytes) { return is(bytes, "LASF"); }

bool begins_e57(std::string_view bytes) { return is(bytes, "ASTM-E57"); }

bool begins_text(std::string_view bytes) { return bytes.find('\0') == bytes.npos; }

}  // namespace cli
