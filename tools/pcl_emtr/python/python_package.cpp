#include "python/python_package.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "failure.h"

namespace cli {
namespace {

constexpr char kPython[] = "python3";
constexpr char kIsThere[] =
    "import importlib.util, sys; sys.exit(importlib.util.find_spec('pyemtr') is None)";

/// What exec wants: pointers into the words, and a null behind them.
std::vector<char*> pointers(std::vector<std::string>& words) {
  std::vector<char*> found;
  found.reserve(words.size() + 1);
  for (auto& word : words) found.push_back(word.data());
  found.push_back(nullptr);
  return found;
}

}  // namespace

bool python_has_pyemtr() {
  try {
    return run_python({"-c", kIsThere}) == 0;
  } catch (const Failure&) {  // there is no python3
    return false;
  }
}

int run_python(const std::vector<std::string>& arguments) {
  std::vector<std::string> words = {kPython};
  words.insert(words.end(), arguments.begin(), arguments.end());
  pid_t child = 0;
  const int fault =
      posix_spawnp(&child, kPython, nullptr, nullptr, pointers(words).data(), environ);
  if (fault != 0) throw FileFailure(kPython, std::string("cannot be run: ") + std::strerror(fault));
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR)
      throw FileFailure(kPython, std::string("cannot be awaited: ") + std::strerror(errno));
  return WIFEXITED(status) ? WEXITSTATUS(status) : kSignal + WTERMSIG(status);
}

void become(const std::string& program, std::vector<std::string> words) {
  execvp(program.c_str(), pointers(words).data());
  if (errno != ENOENT && errno != ENOTDIR)
    throw FileFailure(program, std::string("cannot be run: ") + std::strerror(errno));
}

}  // namespace cli
