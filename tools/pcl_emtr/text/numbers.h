#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace cli {

/// Parses the whole of `text` as a number, or returns nothing. The locale does not matter; "nan"
/// and "inf" in any letter case are numbers, as they are in point cloud files.
std::optional<double> parse_real(std::string_view text);

/// Parses decimal digits only: no sign, no fraction.
std::optional<std::uint64_t> parse_unsigned(std::string_view text);

/// Prints 17 digits, from which the same double is read back.
std::string exact(double value);

/// Prints 9 digits, from which the same float is read back.
std::string exact_single(float value);

/// Prints three digits, for a reader who wants no more.
std::string rounded(double value);

/// Prints as many digits as a reader needs ("1.5", "4000", "1e-05").
std::string brief(double value);

}  // namespace cli
