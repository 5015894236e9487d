#include "write/output_files.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <utility>

#include "failure.h"
#include "files/stream_writer.h"
#include "files/streams.h"

namespace cli {
namespace {

/// Returns where the bytes go: a link's target rather than the link.
std::string place_of(const std::string& path) {
  return std::filesystem::weakly_canonical(std::filesystem::absolute(path)).string();
}

/// Returns the mode of the file to be replaced, or the one that open(2) gives a new file.
mode_t mode_for(const std::string& place) {
  struct stat existing;
  if (stat(place.c_str(), &existing) == 0) return existing.st_mode & 07777;
  const mode_t mask = umask(0);
  umask(mask);
  return 0666 & ~mask;
}

std::string create_temporary(const std::string& path, const std::string& place) {
  const std::filesystem::path target(place);
  std::string name =
      (target.parent_path() / ("." + target.filename().string() + ".XXXXXX")).string();
  const int file = mkstemp(name.data());
  if (file < 0) throw FileFailure(path, std::string("cannot be written: ") + std::strerror(errno));
  fchmod(file, mode_for(place));
  close(file);
  return name;
}

}  // namespace

OutputFiles::~OutputFiles() {
  for (const auto& file : pending_) std::remove(file.temporary.c_str());
}

void OutputFiles::require_writable(const std::string& path) {
  if (is_stream(path)) return require_writable_stream(path);
  const std::string place = place_of(path);
  const auto status = std::filesystem::status(place);
  if (std::filesystem::is_directory(status))
    throw FileFailure(path, "cannot be written: is a directory");
  if (std::filesystem::exists(status) && access(place.c_str(), W_OK) != 0)
    throw FileFailure(path, std::string("cannot be written: ") + std::strerror(errno));
  std::remove(create_temporary(path, place).c_str());
}

void OutputFiles::write(const std::string& path,
                        const std::function<void(const std::string&)>& fill) {
  if (is_stream(path)) {
    auto spool = std::make_unique<Spool>(path);
    fill(spool->place());
    auto bytes = std::make_unique<std::ifstream>(spool->place(), std::ios::binary);
    streams_.push_back({path, std::move(bytes), std::move(spool)});
    return;
  }
  const std::string place = place_of(path);
  pending_.push_back({path, place, create_temporary(path, place)});
  fill(pending_.back().temporary);
}

void OutputFiles::write_text(const std::string& path, const std::string& text) {
  if (is_stream(path)) {
    streams_.push_back({path, std::make_unique<std::istringstream>(text), nullptr});
    return;
  }
  write(path, [&](const std::string& temporary) {
    std::ofstream out(temporary, std::ios::binary);
    out << text;
    out.close();
    if (!out) throw FileFailure(path, "cannot be written whole, is the disk full?");
  });
}

void OutputFiles::commit() {
  for (const Stream& stream : streams_) write_stream(stream.path, *stream.bytes);
  while (!pending_.empty()) {
    const Pending& file = pending_.front();
    if (std::rename(file.temporary.c_str(), file.place.c_str()) != 0)
      throw FileFailure(file.path, std::string("cannot be written: ") + std::strerror(errno));
    pending_.erase(pending_.begin());
  }
}

}  // namespace cli
