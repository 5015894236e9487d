#pragma once

#include <functional>
#include <istream>
#include <memory>
#include <string>
#include <vector>

#include "files/spool.h"

namespace cli {

/// Makes several output files appear together: writes each beside its place first, and renames all
/// when the last one is complete. Removes whatever was not committed. What is no regular file is
/// never replaced: it is written to as a stream, before the files are renamed.
class OutputFiles {
 public:
  OutputFiles() = default;
  OutputFiles(const OutputFiles&) = delete;
  OutputFiles& operator=(const OutputFiles&) = delete;
  ~OutputFiles();

  /// Throws FileFailure unless a file can be written there; leaves nothing behind.
  static void require_writable(const std::string& path);

  /// Calls `fill` with the path of an empty file to write to. Throws FileFailure.
  void write(const std::string& path, const std::function<void(const std::string&)>& fill);
  void write_text(const std::string& path, const std::string& text);

  void commit();

 private:
  struct Pending {
    std::string path;  // as the user gave it
    std::string place;
    std::string temporary;
  };
  struct Stream {
    std::string path;
    std::unique_ptr<std::istream> bytes;
    std::unique_ptr<Spool> spool;  // has the bytes, unless they are in memory
  };
  std::vector<Pending> pending_;
  std::vector<Stream> streams_;
};

}  // namespace cli
