#include "read/npy_reader.h"

#include <array>
#include <fstream>

#include "failure.h"
#include "read/blob.h"
#include "read/text_body.h"
#include "text/numbers.h"
#include "text/words.h"

namespace cli {
namespace {

constexpr char kExpected[] =
    ", expected an array (N, 3) of float32 or float64, little-endian and in C order";

/// Returns the dictionary that describes the array; `in` stands behind it then.
std::string read_header(std::istream& in, const std::string& path) {
  std::array<unsigned char, 12> head{};
  in.read(reinterpret_cast<char*>(head.data()), 8);
  const std::string magic(head.begin(), head.begin() + 6);
  if (!in || magic != "\x93NUMPY") throw FileFailure(path, "not a file of numpy.save");
  const unsigned version = head[6];
  const std::size_t width = version == 1 ? 2 : 4;
  if (version < 1 || version > 3)
    throw FileFailure(path, "has version " + std::to_string(version) + " of npy, expected 1 to 3");
  in.read(reinterpret_cast<char*>(head.data()) + 8, static_cast<std::streamsize>(width));
  std::uint64_t size = 0;
  for (std::size_t i = width; i-- > 0;) size = size << 8 | head[8 + i];
  if (!in || size > bytes_left(in)) throw FileFailure(path, "truncated: ends in its npy header");
  std::string text(size, ' ');
  in.read(text.data(), static_cast<std::streamsize>(size));
  return text;
}

/// Returns what follows the key in the dictionary, up to `end`, without blanks and quotes.
std::string value_of(const std::string& header, const std::string& key, char end,
                     const std::string& path) {
  const std::size_t at = header.find("'" + key + "'");
  const std::size_t colon = at == header.npos ? at : header.find(':', at);
  const std::size_t stop = colon == header.npos ? colon : header.find(end, colon);
  if (stop == header.npos) throw FileFailure(path, "its npy header has no '" + key + "'");
  std::string value;
  for (const char c : header.substr(colon + 1, stop - colon - 1))
    if (c != ' ' && c != '\'' && c != '(') value += c;
  return value;
}

}  // namespace

void read_npy(CloudFile& cloud) {
  std::ifstream in(cloud.place, std::ios::binary);
  const std::string& path = cloud.path;
  const std::string header = read_header(in, path);
  const std::string type = value_of(header, "descr", ',', path);
  const std::string order = value_of(header, "fortran_order", ',', path);
  const std::string shape = value_of(header, "shape", ')', path);
  if (type != "<f4" && type != "<f8")
    throw FileFailure(path, "is an array of type '" + shown(type) + "'" + kExpected);
  if (order != "False") throw FileFailure(path, std::string("is in Fortran's order") + kExpected);
  const std::size_t comma = shape.find(',');
  const auto rows = parse_unsigned(shape.substr(0, comma));
  if (!rows || comma == shape.npos || shape.substr(comma + 1) != "3")
    throw FileFailure(path, "is an array of shape (" + shown(shape) + ")" + kExpected);

  cloud.blob = doubles_blob({"x", "y", "z"});
  if (type == "<f4") {
    cloud.blob.point_step /= 2;
    for (auto& field : cloud.blob.fields) {
      field.datatype = pcl::PCLPointField::FLOAT32;
      field.offset /= 2;
    }
  }
  const std::uint64_t available = bytes_left(in);
  if (*rows > available / cloud.blob.point_step)
    throw FileFailure(path, "truncated: " + std::to_string(available) + " bytes for " +
                                std::to_string(*rows) + " points");
  cloud.blob.data.resize(*rows * cloud.blob.point_step);
  in.read(reinterpret_cast<char*>(cloud.blob.data.data()),
          static_cast<std::streamsize>(cloud.blob.data.size()));
  finish_blob(cloud.blob, path, "rows of x, y, z");
}

}  // namespace cli
