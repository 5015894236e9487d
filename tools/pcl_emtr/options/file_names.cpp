#include "options/file_names.h"

#include <filesystem>

#include "failure.h"
#include "read/cloud_path.h"

namespace cli {
namespace {

void require_file_name(const NamedFile& file) {
  if (file.path.empty()) throw UsageFailure(file.option + ": expected a file name, got nothing");
  if (file.path[0] == '-')
    throw UsageFailure(file.option + ": expected a file name, got '" + file.path +
                       "' (a file of that name is './" + file.path + "')");
}

bool same_file(const NamedFile& a, const NamedFile& b) {
  const auto place = [](const std::string& path) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(path));
  };
  return place(a.path) == place(b.path);
}

void check_extension(const NamedFile& output) {
  const bool cloud = output.option == "--aligned";
  if (!cloud && names_cloud(output.path))
    throw UsageFailure(output.option + ": '" + output.path +
                       "' is named like a cloud, but is a text file; the moved source goes to "
                       "--aligned");
  const std::string extension = extension_of(output.path);
  if (cloud && extension != ".pcd" && extension != ".ply")
    throw FileFailure(output.path, (extension.empty() ? "has no extension"
                                                      : "unknown extension '" + extension + "'") +
                                       ", --aligned expects .pcd or .ply");
}

}  // namespace

void check_file_names(const std::vector<NamedFile>& inputs, const std::vector<NamedFile>& outputs) {
  for (const auto& input : inputs) require_file_name(input);
  for (const auto& output : outputs) require_file_name(output);
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    for (const auto& input : inputs)
      if (same_file(outputs[i], input))
        throw UsageFailure(outputs[i].option + " would overwrite " + input.option + ", '" +
                           input.path + "'");
    for (std::size_t j = 0; j < i; ++j)
      if (same_file(outputs[i], outputs[j]))
        throw UsageFailure(outputs[j].option + " and " + outputs[i].option +
                           " name the same file, '" + outputs[i].path + "'");
    check_extension(outputs[i]);
  }
}

}  // namespace cli
