#include "files/spool.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "failure.h"

namespace cli {
namespace {

int create(const std::string& path) {
  std::error_code error;
  const auto folder = std::filesystem::temp_directory_path(error);
  std::string name = (folder / "pcl_emtr.XXXXXX").string();
  const int file = error ? -1 : mkostemp(name.data(), O_CLOEXEC);
  if (file < 0)
    throw FileFailure(path, "needs a temporary file in TMPDIR, which cannot be made: " +
                                (error ? error.message() : std::strerror(errno)));
  unlink(name.c_str());
  return file;
}

}  // namespace

Spool::Spool(const std::string& path) : path_(path), file_(create(path)) {}

Spool::~Spool() { close(file_); }

std::string Spool::place() const { return "/proc/self/fd/" + std::to_string(file_); }

void Spool::append(const char* bytes, std::size_t count) {
  while (count > 0) {
    const ssize_t written = write(file_, bytes, count);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0)
      throw FileFailure(path_, std::string("does not fit into a temporary file in TMPDIR: ") +
                                   std::strerror(errno));
    bytes += written;
    count -= static_cast<std::size_t>(written);
  }
}

}  // namespace cli
