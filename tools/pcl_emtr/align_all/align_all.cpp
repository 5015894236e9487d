#include "align_all/align_all.h"

#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include "failure.h"
#include "python/python_package.h"

namespace cli {
namespace {

constexpr char kProgram[] = "pyemtr-align";

/// Returns the path of pyemtr-align in the folder of this program, whether it is there or not.
std::string beside_this_program() {
  std::error_code error;
  const auto self = std::filesystem::read_symlink("/proc/self/exe", error);
  return error ? std::string() : (self.parent_path() / kProgram).string();
}

}  // namespace

void run_align_all(const Options& options) {
  std::vector<std::string> words = {kProgram};
  words.insert(words.end(), options.align.arguments.begin(), options.align.arguments.end());
  words.insert(words.end(), {"--", options.align.scans});  // a folder may be called like an option
  const std::string beside = beside_this_program();
  if (!beside.empty()) become(beside, words);
  become(kProgram, words);
  if (python_has_pyemtr()) {
    words.erase(words.begin());
    words.insert(words.begin(), {"python3", "-m", "pyemtr.multiway"});
    become("python3", words);
  }
  throw Failure(kInputOutput,
                "--align-all runs pyemtr-align, which is neither beside this program nor in PATH, "
                "and python3 has no package pyemtr; install it: pip install 'pyemtr[align]'");
}

}  // namespace cli
