#pragma once

#include <cstddef>
#include <cstdint>
#include <istream>
#include <string>

namespace cli {

/// Checks `rows` lines of `columns` numbers each, and skips empty lines; `columns` 0 allows any
/// number of them. Throws FileFailure, whose message calls a row a `kind`.
void check_rows(std::istream& in, const std::string& path, std::uint64_t rows, std::size_t columns,
                const std::string& kind);

/// Throws FileFailure when anything but white space follows the `rows` rows.
void require_end(std::istream& in, const std::string& path, std::uint64_t rows,
                 const std::string& kind);

/// Returns the number of bytes from the position of `in` to the end of the file.
std::uint64_t bytes_left(std::istream& in);

}  // namespace cli
