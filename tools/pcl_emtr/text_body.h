#pragma once

#include <cstdint>
#include <istream>
#include <string>

namespace cli {

/// Reads `rows` lines of `columns` numbers, skipping empty lines; `columns` 0 takes any number
/// of them. `kind` is what a row is called in the message of the FileFailure.
void check_rows(std::istream& in, const std::string& path, std::uint64_t rows, std::size_t columns,
                const std::string& kind);

/// Throws FileFailure when anything but white space is left after `rows` rows.
void require_end(std::istream& in, const std::string& path, std::uint64_t rows,
                 const std::string& kind);

/// The size of a file's rest, from where `in` stands.
std::uint64_t bytes_left(std::istream& in);

}  // namespace cli
