#include "files/streams.h"

#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <system_error>

#include "text/numbers.h"

namespace cli {

namespace fs = std::filesystem;

std::optional<int> descriptor_of(const std::string& path) {
  if (path == "/dev/stdin") return STDIN_FILENO;
  if (path == "/dev/stdout") return STDOUT_FILENO;
  if (path == "/dev/stderr") return STDERR_FILENO;
  std::error_code error;
  const fs::path open_files = fs::canonical("/proc/self/fd", error);
  if (error) return std::nullopt;
  fs::path here = fs::absolute(path, error);
  for (int links = 0; links < 40 && !error; ++links) {
    const fs::path folder = fs::canonical(here.parent_path(), error);
    if (error) break;
    if (folder == open_files) {
      const auto number = parse_unsigned(here.filename().string());
      if (!number || *number > 0x7fffffffu) break;
      return static_cast<int>(*number);
    }
    if (!fs::is_symlink(fs::symlink_status(folder / here.filename(), error))) break;
    here = folder / fs::read_symlink(folder / here.filename(), error);
  }
  return std::nullopt;
}

bool is_stream(const std::string& path) {
  if (descriptor_of(path)) return true;
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  return !error && fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

std::string stream_name(const std::string& path) {
  if (const auto descriptor = descriptor_of(path)) return "open " + std::to_string(*descriptor);
  struct stat found;
  if (stat(path.c_str(), &found) != 0 || !S_ISFIFO(found.st_mode)) return "";
  return "pipe " + std::to_string(found.st_dev) + ":" + std::to_string(found.st_ino);
}

}  // namespace cli
