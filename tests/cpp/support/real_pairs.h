#pragma once

#include <emtr/emtr.h>

#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace emtr_test {

/// A pair of measured clouds from the folder that the variable EMTR_DATA names.
class RealPair {
 public:
  static bool available() { return std::getenv("EMTR_DATA") != nullptr; }

  explicit RealPair(const std::string& name)
      : source_(read(name + "/source.ply")), target_(read(name + "/target.ply")) {}

  emtr_cloud source() const { return {source_.data(), source_.size() / 3, 0, EMTR_FLOAT32}; }
  emtr_cloud target() const { return {target_.data(), target_.size() / 3, 0, EMTR_FLOAT32}; }

 private:
  /// Binary PLY that holds nothing but x, y, z as float.
  static std::vector<float> read(const std::string& name) {
    const std::string path = std::string(std::getenv("EMTR_DATA")) + "/pairs/" + name;
    std::ifstream file(path, std::ios::binary);
    std::size_t count = 0, properties = 0;
    bool little = false;
    for (std::string line; std::getline(file, line) && line != "end_header";) {
      little |= line == "format binary_little_endian 1.0";
      properties += line.rfind("property float ", 0) == 0;
      if (line.rfind("element vertex ", 0) == 0) count = std::stoul(line.substr(15));
    }
    std::vector<float> out(3 * count);
    file.read(reinterpret_cast<char*>(out.data()),
              static_cast<std::streamsize>(out.size() * sizeof(float)));
    if (!file || !little || properties != 3 || count == 0)
      throw std::runtime_error(path + " is not a binary PLY of x, y, z");
    return out;
  }

  std::vector<float> source_, target_;
};

}  // namespace emtr_test
