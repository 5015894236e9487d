#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace cli {

/// Splits a line at blanks, tabs and carriage returns.
std::vector<std::string_view> words_of(std::string_view line);

/// Returns the beginning of a word from a file, with '?' for bytes that a terminal cannot print.
std::string shown(std::string_view word);

/// Joins names with ", " and, before the last one, with `last`: "grid, kdtree or brute".
std::string joined(const std::vector<std::string>& names, const std::string& last = ", ");

/// Breaks a text into lines of at most `width` characters.
std::string wrapped(const std::string& text, std::size_t width = 66);

}  // namespace cli
