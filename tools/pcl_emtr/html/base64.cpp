#include "html/base64.h"

#include <cstddef>

namespace cli {

std::string base64(const std::vector<std::uint16_t>& values) {
  static constexpr char kDigits[] =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const std::size_t bytes = 2 * values.size();
  const auto byte = [&](std::size_t i) -> unsigned {
    return i < bytes ? (values[i / 2] >> (i % 2 ? 8 : 0)) & 0xFFU : 0U;
  };
  std::string out;
  out.reserve((bytes + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes; i += 3) {
    const unsigned group = byte(i) << 16 | byte(i + 1) << 8 | byte(i + 2);
    out += kDigits[group >> 18];
    out += kDigits[group >> 12 & 63U];
    out += i + 1 < bytes ? kDigits[group >> 6 & 63U] : '=';
    out += i + 2 < bytes ? kDigits[group & 63U] : '=';
  }
  return out;
}

}  // namespace cli
