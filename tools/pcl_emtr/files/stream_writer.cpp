#include "files/stream_writer.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstring>
#include <vector>

#include "failure.h"
#include "files/streams.h"
#include "interrupt.h"

namespace cli {
namespace {

[[noreturn]] void fail(const std::string& path) {
  const int error = errno;
  if (error == EINTR)
    throw Failure(kSignal + Interrupt::number(), "stopped before '" + path + "' was written");
  const std::string what = std::string("cannot be written: ") + std::strerror(error);
  if (descriptor_of(path) == STDOUT_FILENO) throw Failure(kInputOutput, "standard output " + what);
  throw FileFailure(path, what);
}

/// An open file of its own, which is closed in the end.
class Opened {
 public:
  explicit Opened(const std::string& path) {
    const auto descriptor = descriptor_of(path);
    file_ = descriptor ? fcntl(*descriptor, F_DUPFD_CLOEXEC, 0)
                       : open(path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC | O_NOCTTY);
    if (file_ < 0) fail(path);
  }
  ~Opened() { close(file_); }
  Opened(const Opened&) = delete;
  Opened& operator=(const Opened&) = delete;

  operator int() const { return file_; }

 private:
  int file_;
};

}  // namespace

void require_writable_stream(const std::string& path) {
  if (const auto descriptor = descriptor_of(path)) {
    const int flags = fcntl(*descriptor, F_GETFL);
    if (flags >= 0 && (flags & O_ACCMODE) == O_RDONLY) errno = EBADF;
    if (flags < 0 || (flags & O_ACCMODE) == O_RDONLY) fail(path);
  } else if (access(path.c_str(), W_OK) != 0) {
    fail(path);
  }
}

void write_stream(const std::string& path, std::istream& in) {
  const Opened out(path);
  std::vector<char> block(1 << 16);
  while (in.read(block.data(), static_cast<std::streamsize>(block.size())) || in.gcount() > 0) {
    const char* bytes = block.data();
    for (auto left = static_cast<std::size_t>(in.gcount()); left > 0;) {
      const ssize_t written = write(out, bytes, left);
      if (written < 0) fail(path);
      bytes += written;
      left -= static_cast<std::size_t>(written);
    }
  }
}

}  // namespace cli
