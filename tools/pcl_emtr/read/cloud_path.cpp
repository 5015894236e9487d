#include "read/cloud_path.h"

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "failure.h"

namespace cli {

std::string extension_of(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

bool names_cloud(const std::string& path) {
  const std::string extension = extension_of(path);
  return extension == ".pcd" || extension == ".ply" || extension == ".obj";
}

void require_cloud_file(const std::string& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found)
    throw FileFailure(path, "no such file");
  if (error) throw FileFailure(path, error.message());
  if (std::filesystem::is_directory(status))
    throw FileFailure(path, "is a directory, expected a .pcd, .ply or .obj file");
  if (!std::filesystem::is_regular_file(status))
    throw FileFailure(path, "is not a regular file, expected a .pcd, .ply or .obj file");
  const std::string extension = extension_of(path);
  if (!names_cloud(path))
    throw FileFailure(
        path, (extension.empty() ? "has no extension" : "unknown extension '" + extension + "'") +
                  ", expected .pcd, .ply or .obj");
  if (access(path.c_str(), R_OK) != 0) throw FileFailure(path, std::strerror(errno));
  if (std::filesystem::file_size(path) == 0) throw FileFailure(path, "is empty");
}

}  // namespace cli
