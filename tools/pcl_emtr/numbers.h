#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cli {

/// The whole of `text` as a number, or nothing. Independent of the locale; "nan" and "inf" in
/// any letter case are numbers, as they are in point cloud files.
std::optional<double> parse_real(std::string_view text);

/// Decimal digits only: no sign, no fraction.
std::optional<std::uint64_t> parse_unsigned(std::string_view text);

/// The words of a line; blanks, tabs and carriage returns separate them.
std::vector<std::string_view> words_of(std::string_view line);

/// The beginning of a word from a file, fit for a message whatever bytes it holds.
std::string shown(std::string_view word);

/// Seventeen digits, from which the same double is read back.
std::string exact(double value);

/// As many digits as a reader needs ("1.5", "4000", "1e-05").
std::string brief(double value);

}  // namespace cli
