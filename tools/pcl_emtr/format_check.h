#pragma once

#include <cstdint>
#include <string>

namespace cli {

// PCL's readers crash on a PCD file without a header, turn words that are no numbers into
// zeros, keep the points that a text file breaks off before, and allocate whatever size a
// header declares. These checks come first: they read the header, hold what it declares
// against what the file contains, and read every number of a text file.
// Each returns the number of points declared or throws FileFailure.

std::uint64_t check_pcd(const std::string& path);
std::uint64_t check_ply(const std::string& path);

}  // namespace cli
