#pragma once

#include <array>
#include <cstdint>
#include <istream>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace cli {

/// The header of a PCD file, by keyword. Every member throws FileFailure on a line that is missing
/// or malformed.
class PcdHeader {
 public:
  using Words = std::vector<std::string>;

  /// Reads the lines up to DATA, which it includes.
  PcdHeader(std::istream& in, const std::string& path);

  /// Throws FileFailure when the points behind DATA, where `in` stands, begin like a header line:
  /// PCL goes on reading header lines for as long as it finds any, also in a binary file.
  void require_end(std::istream& in) const;

  bool has(const std::string& key) const { return lines_.count(key) > 0; }
  const Words& words(const std::string& key) const;

  /// Returns a count, which PCL holds in 32 bits.
  std::uint64_t whole(const std::string& key, const std::string& word) const;
  std::uint64_t whole(const std::string& key) const { return whole(key, words(key).front()); }

  /// Returns the sensor's position and orientation (w, x, y, z), or nothing without such a line.
  std::optional<std::array<double, 7>> viewpoint() const;

 private:
  std::string path_;
  std::map<std::string, Words> lines_;
};

}  // namespace cli
