#pragma once

#include <pcl/console/print.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

#include "input.h"

namespace fuzz {

/// A folder in TMPDIR for this process alone, which is removed when the process ends.
class Scratch {
 public:
  Scratch() {
    std::string name = (std::filesystem::temp_directory_path() / "emtr-fuzz-XXXXXX").string();
    require(mkdtemp(name.data()) != nullptr);
    folder_ = name;
    // PCL's readers print more about each file than reading it costs.
    pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  }
  ~Scratch() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  /// Writes a file of these bytes; returns its path.
  std::string file(const std::string& name, const std::uint8_t* data, std::size_t size) const {
    std::ofstream out(path(name), std::ios::binary);
    out.write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
    out.close();
    require(out.good());
    return path(name);
  }

 private:
  std::filesystem::path folder_;
};

}  // namespace fuzz
