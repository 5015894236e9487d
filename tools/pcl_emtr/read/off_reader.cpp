#include "read/off_reader.h"

#include <algorithm>
#include <fstream>
#include <vector>

#include "failure.h"
#include "read/blob.h"
#include "read/text_body.h"
#include "text/numbers.h"
#include "text/words.h"

namespace cli {
namespace {

/// The lines of an OFF file without comments and empty ones.
class OffLines {
 public:
  OffLines(std::istream& in, const std::string& path) : in_(in), path_(path) {}

  /// Returns the words of the next line; `what` is what is expected there.
  const std::vector<std::string_view>& next(const std::string& what) {
    while (std::getline(in_, text_)) {
      ++number_;
      words_ = words_of(std::string_view(text_).substr(0, text_.find('#')));
      if (!words_.empty()) return words_;
    }
    throw FileFailure(path_, "truncated: ends where " + what + " is expected");
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw FileFailure(path_, "line " + std::to_string(number_) + ": " + what);
  }

  std::uint64_t whole(std::size_t i) const {
    const auto value = i < words_.size() ? parse_unsigned(words_[i]) : std::nullopt;
    if (!value || *value > 0xffffffffu)
      fail("expected a whole number from 0, got '" + (i < words_.size() ? shown(words_[i]) : "") +
           "'");
    return *value;
  }

  double real(std::size_t i) const {
    const auto value = parse_real(words_[i]);
    if (!value) fail("'" + shown(words_[i]) + "' is not a number");
    return *value;
  }

 private:
  std::istream& in_;
  const std::string& path_;
  std::string text_;
  std::vector<std::string_view> words_;
  std::uint64_t number_ = 0;
};

/// Reads the keyword, and the counts behind it or on the next line; returns where these begin.
std::size_t read_head(OffLines& lines, const std::string& path) {
  const auto& words = lines.next("the keyword OFF");
  const std::size_t at = words[0].find("OFF");
  if (at == std::string_view::npos || words[0].find_first_not_of("STCN4n") < at)
    throw FileFailure(path, "not an OFF file, expected a first line 'OFF'");
  if (words[0].find_first_of("4n") < at)
    throw FileFailure(path, "has vertices of four coordinates or more, expected three");
  if (words.size() > 1 && words[1] == "BINARY")
    throw FileFailure(path, "is a binary OFF file, expected an ascii one");
  if (words[0].size() > at + 3) lines.fail("expected 'OFF' and a blank before the counts");
  if (words.size() > 1) return 1;
  lines.next("the line of counts");
  return 0;
}

void read_vertices(OffLines& lines, std::uint64_t vertices, CloudFile& cloud) {
  std::size_t columns = 0;
  for (std::uint64_t row = 0; row < vertices; ++row) {
    const auto& words = lines.next("vertex " + std::to_string(row + 1));
    if (words.size() < 3) lines.fail("expected the three coordinates of a vertex");
    columns = std::max(columns, words.size());
    const double values[3] = {lines.real(0), lines.real(1), lines.real(2)};
    add_point(cloud.blob, values);
  }
  if (columns > 3) cloud.add_note("what follows the coordinates of its vertices is left out");
}

void read_faces(OffLines& lines, std::uint64_t count, Faces& faces) {
  for (std::uint64_t row = 0; row < count; ++row) {
    const auto& words = lines.next("face " + std::to_string(row + 1));
    const std::uint64_t corners = lines.whole(0);
    if (corners >= words.size()) lines.fail("expected the vertices of a face, as many as it says");
    for (std::size_t i = 1; i <= corners; ++i)
      faces.corners.push_back(static_cast<std::uint32_t>(lines.whole(i)));
    faces.close();
  }
}

}  // namespace

void read_off(CloudFile& cloud) {
  std::ifstream in(cloud.place, std::ios::binary);
  const std::uint64_t bytes = bytes_left(in);
  OffLines lines(in, cloud.path);
  const std::size_t at = read_head(lines, cloud.path);
  const std::uint64_t vertices = lines.whole(at), faces = lines.whole(at + 1);
  // A vertex takes three digits and three separators at least, a face two of each.
  if (vertices > (bytes + 1) / 6 || faces > (bytes + 1) / 4)
    throw FileFailure(cloud.path, "truncated: it declares " + std::to_string(vertices) +
                                      " vertices and " + std::to_string(faces) +
                                      " faces, but has " + std::to_string(bytes) + " bytes");
  cloud.blob = doubles_blob({"x", "y", "z"});
  reserve_points(cloud.blob, vertices);
  read_vertices(lines, vertices, cloud);
  finish_blob(cloud.blob, cloud.path, "OFF vertices");
  read_faces(lines, faces, cloud.faces);
  require_corners(cloud.faces, cloud.size(), cloud.path);
}

}  // namespace cli
