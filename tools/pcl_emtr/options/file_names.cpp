#include "options/file_names.h"

#include <cstddef>
#include <filesystem>

#include "failure.h"
#include "files/streams.h"
#include "formats/format.h"
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
  if (is_stream(a.path) || is_stream(b.path)) return false;  // check_streams() sees to these
  const auto place = [](const std::string& path) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(path));
  };
  return place(a.path) == place(b.path);
}

void check_text(const NamedFile& output) {
  const Format* format = format_of(output.path);
  if (format && !format->for_any_text)
    throw UsageFailure(output.option + ": '" + output.path +
                       "' is named like a cloud, but is a text file; the moved source goes to "
                       "--aligned");
}

void check_aligned(const std::string& path, const std::string& named_format) {
  if (is_compressed(path))
    throw FileFailure(path, "--aligned does not compress; write to - and pipe that to gzip");
  const Format* format = format_of(path);
  if (!named_format.empty() || (format && format->written)) return;
  if (!format && is_stream(path)) return;
  throw FileFailure(
      path,
      (format ? std::string("is named like a format that is only read") : wrong_extension(path)) +
          ", --aligned expects " + written_extensions() + ", or --aligned-format");
}

}  // namespace

void check_file_names(const std::vector<NamedFile>& inputs, const std::vector<NamedFile>& outputs,
                      const std::string& aligned_format) {
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
    outputs[i].option == "--aligned" ? check_aligned(outputs[i].path, aligned_format)
                                     : check_text(outputs[i]);
  }
}

}  // namespace cli
