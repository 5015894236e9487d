#pragma once

#include <cstdint>
#include <string>

namespace cli {

// PCL's readers crash on a PCD file without a header, turn words that are no numbers into zeros,
// fill up a text file that breaks off with points of their own, and allocate whatever size a header
// declares. These checks therefore run first: they read the header, compare what it declares with
// what the file contains, and parse every number of a text file.
// Each opens `place`, and returns the number of points that the header declares, or throws
// FileFailure about `path`.

std::uint64_t check_pcd(const std::string& place, const std::string& path);
std::uint64_t check_ply(const std::string& place, const std::string& path);

}  // namespace cli
