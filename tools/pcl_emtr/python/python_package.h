#pragma once

#include <string>
#include <vector>

namespace cli {

/// Tells whether python3 has the package pyemtr.
bool python_has_pyemtr();

/// Runs python3 with these arguments until it ends. Returns its exit code, or 128 and the number of
/// the signal that ended it. Throws a Failure when it cannot be run.
int run_python(const std::vector<std::string>& arguments);

/// Becomes this program, which is looked for in PATH if its name has no slash. Returns only if
/// there is none; throws a FileFailure when it is there and cannot be run.
void become(const std::string& program, std::vector<std::string> words);

}  // namespace cli
