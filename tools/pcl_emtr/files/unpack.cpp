#include "files/unpack.h"

#include <fcntl.h>
#include <unistd.h>
#include <zlib.h>

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <new>
#include <vector>

#include "failure.h"
#include "files/streams.h"

namespace cli {
namespace {

struct CloseGzip {
  void operator()(gzFile file) const { gzclose(file); }
};
using Gzip = std::unique_ptr<gzFile_s, CloseGzip>;

constexpr unsigned kBlock = 1 << 18;

std::uint64_t memory() {
  return static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)) *
         static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

Gzip open_gzip(const std::string& path) {
  const auto descriptor = descriptor_of(path);
  const int file = descriptor ? fcntl(*descriptor, F_DUPFD_CLOEXEC, 0)
                              : open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) throw FileFailure(path, std::strerror(errno));
  Gzip gzip(gzdopen(file, "rb"));
  if (!gzip) {
    close(file);
    throw std::bad_alloc();
  }
  gzbuffer(gzip.get(), kBlock);
  return gzip;
}

[[noreturn]] void fail(const std::string& path, gzFile file) {
  int code = Z_OK;
  const std::string text = gzerror(file, &code);
  if (code == Z_BUF_ERROR) throw FileFailure(path, "truncated: its gzip data end too early");
  if (code == Z_MEM_ERROR) throw std::bad_alloc();
  if (code == Z_ERRNO) throw FileFailure(path, std::strerror(errno));
  throw FileFailure(path, "damaged: its gzip data cannot be unpacked (" + text + ")");
}

/// Fills the block, for as long as there is something to read; returns the number of bytes.
std::size_t read_block(const std::string& path, gzFile file, std::vector<char>& block) {
  const int count = gzread(file, block.data(), kBlock);
  int code = Z_OK;
  gzerror(file, &code);
  if (count < 0 || code == Z_BUF_ERROR) fail(path, file);
  return static_cast<std::size_t>(count);
}

}  // namespace

std::shared_ptr<Spool> unpack(const std::string& path,
                              const std::function<void(std::string_view)>& check) {
  const Gzip file = open_gzip(path);
  auto spool = std::make_shared<Spool>(path);
  std::vector<char> block(kBlock);
  std::uint64_t total = 0;
  while (const std::size_t count = read_block(path, file.get(), block)) {
    if (total == 0) {
      if (!is_stream(path) && gzdirect(file.get()))
        throw FileFailure(path, "is not compressed by gzip, as its extension says");
      check({block.data(), count});
    }
    total += count;
    if (total > memory())
      throw FileFailure(path,
                        "has more bytes than this machine has memory, " + std::to_string(memory()));
    spool->append(block.data(), count);
  }
  if (total == 0) throw FileFailure(path, "is empty");
  return spool;
}

}  // namespace cli
