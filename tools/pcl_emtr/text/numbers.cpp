#include "text/numbers.h"

#include <charconv>
#include <cstdio>
#include <system_error>

namespace cli {
namespace {

template <class T>
std::optional<T> parse_whole(std::string_view text) {
  T value{};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end || text.empty()) return std::nullopt;
  return value;
}

std::string printed(const char* format, double value) {
  char text[40];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

}  // namespace

std::optional<double> parse_real(std::string_view text) {
  // std::from_chars refuses a leading plus, which some programs write.
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  return parse_whole<double>(text);
}

std::optional<std::uint64_t> parse_unsigned(std::string_view text) {
  return parse_whole<std::uint64_t>(text);
}

std::string exact(double value) { return printed("%.17g", value); }

std::string exact_single(float value) { return printed("%.9g", value); }

std::string rounded(double value) { return printed("%.3g", value); }

std::string brief(double value) { return printed("%.7g", value); }

}  // namespace cli
