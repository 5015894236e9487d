#include "read/cloud_path.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "failure.h"
#include "files/streams.h"
#include "formats/format.h"

namespace cli {

std::string lower_case(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

bool is_compressed(const std::string& path) {
  return lower_case(std::filesystem::path(path).extension().string()) == ".gz";
}

std::string extension_of(const std::string& path) {
  const std::filesystem::path whole(path);
  const std::string last = lower_case(whole.extension().string());
  return last == ".gz" ? lower_case(whole.stem().extension().string()) : last;
}

std::string wrong_extension(const std::string& path) {
  const std::string extension = extension_of(path);
  return extension.empty() ? "has no extension" : "unknown extension '" + extension + "'";
}

void require_cloud_file(const std::string& path, const std::string& format) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found)
    throw FileFailure(path, "no such file");
  if (std::filesystem::is_directory(status))
    throw FileFailure(path, "is a directory, expected a file: " + read_extensions());
  if (access(path.c_str(), R_OK) != 0) throw FileFailure(path, std::strerror(errno));
  if (is_stream(path)) return;
  if (error) throw FileFailure(path, error.message());
  if (format.empty() && !format_of(path))
    throw FileFailure(
        path, wrong_extension(path) + ", expected " + read_extensions() + ", or --input-format");
  if (std::filesystem::file_size(path) == 0) throw FileFailure(path, "is empty");
}

}  // namespace cli
