#include "options/stream_names.h"

#include <map>

#include "failure.h"
#include "files/streams.h"

namespace cli {
namespace {

void check_once(const std::vector<NamedFile>& files, std::map<std::string, std::string> users,
                const std::string& what) {
  for (const auto& file : files) {
    const std::string name = is_stream(file.path) ? stream_name(file.path) : "";
    if (name.empty()) continue;
    const auto [user, is_new] = users.emplace(name, file.option);
    if (!is_new)
      throw UsageFailure(user->second + " and " + file.option + " both " + what + " '" + file.path +
                         "'");
  }
}

}  // namespace

void check_streams(const std::vector<NamedFile>& inputs, const std::vector<NamedFile>& outputs,
                   bool matrix_on_output) {
  check_once(inputs, {}, "read the stream");
  std::map<std::string, std::string> users;
  if (matrix_on_output) users.emplace(stream_name("/dev/stdout"), "the matrix (without --output)");
  check_once(outputs, users, "write to the stream");
}

}  // namespace cli
