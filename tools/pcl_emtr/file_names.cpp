#include "file_names.h"

#include <filesystem>

#include "cloud_file.h"
#include "failure.h"

namespace cli {
namespace {

void require_file_name(const NamedFile& file) {
  if (file.path.empty()) throw UsageFailure(file.option + ": expected a file name, got nothing");
  if (file.path[0] == '-')
    throw UsageFailure(file.option + ": expected a file name, got '" + file.path +
                       "' (a file of that name is './" + file.path + "')");
}

bool holds_cloud(const std::string& path) {
  const std::string extension = extension_of(path);
  return extension == ".pcd" || extension == ".ply" || extension == ".obj";
}

std::filesystem::path place_of(const std::string& path) {
  return std::filesystem::weakly_canonical(std::filesystem::absolute(path));
}

}  // namespace

void check_file_names(const std::vector<NamedFile>& inputs, const std::vector<NamedFile>& outputs) {
  for (const auto& input : inputs) require_file_name(input);
  for (const auto& output : outputs) require_file_name(output);
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    for (const auto& input : inputs)
      if (place_of(outputs[i].path) == place_of(input.path))
        throw UsageFailure(outputs[i].option + " would overwrite " + input.option + ", '" +
                           input.path + "'");
    for (std::size_t j = 0; j < i; ++j)
      if (place_of(outputs[i].path) == place_of(outputs[j].path))
        throw UsageFailure(outputs[j].option + " and " + outputs[i].option +
                           " name the same file, '" + outputs[i].path + "'");
    const bool cloud = outputs[i].option == "--aligned";
    if (!cloud && holds_cloud(outputs[i].path))
      throw UsageFailure(outputs[i].option + ": '" + outputs[i].path +
                         "' is named like a cloud, "
                         "but is to be a text; the moved source goes to --aligned");
    const std::string extension = extension_of(outputs[i].path);
    if (cloud && extension != ".pcd" && extension != ".ply")
      throw FileFailure(
          outputs[i].path,
          (extension.empty() ? "has no extension" : "unknown extension '" + extension + "'") +
              ", --aligned expects .pcd or .ply");
  }
}

}  // namespace cli
