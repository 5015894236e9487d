#pragma once

#include <array>
#include <cstdint>
#include <istream>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace cli {

/// The header of a PCD file, line by line; every member throws FileFailure on what is missing.
class PcdHeader {
 public:
  using Words = std::vector<std::string>;

  /// Reads up to and with the line DATA.
  PcdHeader(std::istream& in, const std::string& path);

  /// PCL reads header lines for as long as there are any, also behind DATA, where a binary file has
  /// its points. `in` stands there.
  void require_end(std::istream& in) const;

  bool has(const std::string& key) const { return lines_.count(key) > 0; }
  const Words& words(const std::string& key) const;

  /// A count as PCL holds it, in 32 bits.
  std::uint64_t whole(const std::string& key, const std::string& word) const;
  std::uint64_t whole(const std::string& key) const { return whole(key, words(key).front()); }

  /// The sensor's position and orientation (w, x, y, z), if there is such a line.
  std::optional<std::array<double, 7>> viewpoint() const;

 private:
  std::string path_;
  std::map<std::string, Words> lines_;
};

}  // namespace cli
