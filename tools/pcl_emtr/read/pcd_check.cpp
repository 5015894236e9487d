#include <algorithm>
#include <array>
#include <cstddef>
#include <fstream>

#include "failure.h"
#include "read/format_check.h"
#include "read/pcd_header.h"
#include "read/text_body.h"
#include "text/words.h"

namespace cli {
namespace {

struct Layout {
  std::uint64_t values = 0;  // of one point
  std::uint64_t bytes = 0;
};

Layout layout_of(const PcdHeader& header, const std::string& path) {
  const PcdHeader::Words& fields = header.words(header.has("COLUMNS") ? "COLUMNS" : "FIELDS");
  const PcdHeader::Words& sizes = header.words("SIZE");
  const PcdHeader::Words& types = header.words("TYPE");
  const PcdHeader::Words counts =
      header.has("COUNT") ? header.words("COUNT") : PcdHeader::Words(fields.size(), "1");
  if (sizes.size() != fields.size() || types.size() != fields.size() ||
      counts.size() != fields.size())
    throw FileFailure(path, "its PCD header has " + std::to_string(fields.size()) +
                                " FIELDS, but " + std::to_string(sizes.size()) + " SIZE, " +
                                std::to_string(types.size()) + " TYPE and " +
                                std::to_string(counts.size()) + " COUNT");
  Layout layout;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const bool real = types[i] == "F" && (sizes[i] == "4" || sizes[i] == "8");
    const bool integer = (types[i] == "I" || types[i] == "U") &&
                         (sizes[i] == "1" || sizes[i] == "2" || sizes[i] == "4" || sizes[i] == "8");
    if (!real && !integer)
      throw FileFailure(path, "its PCD header gives field '" + shown(fields[i]) + "' type " +
                                  shown(types[i]) + " of size " + shown(sizes[i]) +
                                  ", which PCD does not have");
    const std::uint64_t count = header.whole("COUNT", counts[i]);
    if (count == 0)
      throw FileFailure(path, "its PCD header gives field '" + shown(fields[i]) + "' COUNT 0");
    layout.values += count;
    layout.bytes += count * header.whole("SIZE", sizes[i]);
  }
  return layout;
}

void check_compressed(std::istream& in, const std::string& path, std::uint64_t bytes) {
  std::array<unsigned char, 8> sizes{};
  if (!in.read(reinterpret_cast<char*>(sizes.data()), sizes.size()))
    throw FileFailure(path, "truncated: ends before its compressed points");
  const auto little_endian = [&](std::size_t at) {
    std::uint64_t value = 0;
    for (std::size_t i = 4; i-- > 0;) value = value << 8 | sizes[at + i];
    return value;
  };
  const std::uint64_t packed = little_endian(0);
  if (packed > bytes_left(in))
    throw FileFailure(path, "truncated: " + std::to_string(bytes_left(in)) + " of " +
                                std::to_string(packed) + " compressed bytes");
  if (little_endian(4) != bytes)
    throw FileFailure(path, "damaged: its compressed part unpacks to " +
                                std::to_string(little_endian(4)) + " bytes, its header declares " +
                                std::to_string(bytes));
  // LZF packs at most 264 bytes into three, so no fewer than this can be right.
  if (bytes / 264 > packed)
    throw FileFailure(path, "damaged: " + std::to_string(packed) +
                                " compressed bytes cannot unpack to " + std::to_string(bytes));
}

}  // namespace

std::uint64_t check_pcd(const std::string& place, const std::string& path) {
  std::ifstream in(place, std::ios::binary);
  const PcdHeader header(in, path);
  const Layout layout = layout_of(header, path);
  if (layout.bytes == 0) throw FileFailure(path, "its PCD header has no FIELDS");
  header.viewpoint();  // throws when it is malformed
  const std::uint64_t height = header.has("HEIGHT") ? header.whole("HEIGHT") : 1;
  const std::uint64_t points = header.whole("WIDTH") * height;
  if (header.has("POINTS") && header.whole("POINTS") != points)
    throw FileFailure(path, "its PCD header has POINTS " + header.words("POINTS").front() +
                                ", but WIDTH x HEIGHT is " + std::to_string(points));
  if (points == 0) throw FileFailure(path, "holds no points");
  const std::string& data = header.words("DATA").front();

  const bool text = data == "ascii";
  if (!text) header.require_end(in);
  const std::uint64_t available = bytes_left(in);
  // In text a value takes at least a digit and a separator; the last one needs no separator.
  const std::uint64_t least = text ? 2 * layout.values : layout.bytes;
  if (data != "binary_compressed" && points > (available + 1) / least) {
    throw FileFailure(path, "truncated: its header declares " + std::to_string(points) +
                                " points, " + std::to_string(available) +
                                " bytes are left for them");
  }
  if (text) {
    check_rows(in, path, points, layout.values, "point");
    require_end(in, path, points, "point");
  } else if (data == "binary_compressed") {
    if (points > 0xffffffffu / layout.bytes)
      throw FileFailure(path, "its header declares " + std::to_string(points) +
                                  " points, more than a compressed PCD file can hold");
    check_compressed(in, path, points * layout.bytes);
  } else if (data != "binary") {
    throw FileFailure(path, "its PCD header has DATA '" + shown(data) +
                                "', expected ascii, binary or binary_compressed");
  }
  return points;
}

}  // namespace cli
