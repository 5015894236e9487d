#pragma once

#include <pcl/console/print.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

#include "input.h"

namespace fuzz {

/// A folder of this process alone, in TMPDIR, that goes when the process ends.
class Scratch {
 public:
  Scratch() {
    std::string name = (std::filesystem::temp_directory_path() / "emtr-fuzz-XXXXXX").string();
    require(mkdtemp(name.data()) != nullptr);
    folder_ = name;
    // What PCL's readers say of each file would cost more than reading it.
    pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  }
  ~Scratch() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  /// A file of just these bytes.
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
