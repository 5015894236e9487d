#pragma once

#include <cstddef>
#include <string>

namespace cli {

/// A temporary file in TMPDIR that has no name, so that nothing of it is left however the process
/// ends. It takes what has to be read more than once, or written whole, but comes from a stream or
/// goes to one.
class Spool {
 public:
  /// Throws FileFailure about `path`, which is the file that the bytes come from or go to.
  explicit Spool(const std::string& path);
  ~Spool();
  Spool(const Spool&) = delete;
  Spool& operator=(const Spool&) = delete;

  /// Returns a path by which it can be opened while it lives.
  std::string place() const;

  /// Adds bytes at the end; throws FileFailure when the disk is full.
  void append(const char* bytes, std::size_t count);

 private:
  std::string path_;
  int file_;
};

}  // namespace cli
