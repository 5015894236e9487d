#pragma once

#include <functional>
#include <string>
#include <vector>

namespace cli {

/// Several output files that appear together: each is written beside its place first, and put
/// there by rename when all are complete. Whatever was not committed leaves nothing behind.
class OutputFiles {
 public:
  OutputFiles() = default;
  OutputFiles(const OutputFiles&) = delete;
  OutputFiles& operator=(const OutputFiles&) = delete;
  ~OutputFiles();

  /// Tries whether a file can be put there; leaves nothing. Throws FileFailure.
  static void require_writable(const std::string& path);

  /// `fill` gets the name of an empty file to write to. Throws FileFailure.
  void write(const std::string& path, const std::function<void(const std::string&)>& fill);
  void write_text(const std::string& path, const std::string& text);

  void commit();

 private:
  struct Pending {
    std::string path;  // as the user gave it
    std::string place;
    std::string temporary;
  };
  std::vector<Pending> pending_;
};

}  // namespace cli
