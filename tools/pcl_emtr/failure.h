#pragma once

#include <stdexcept>
#include <string>

namespace cli {

/// What the process returns; documented in --help.
enum ExitCode { kRegistered = 0, kUsage = 1, kInputOutput = 2, kNotRegistered = 3 };

/// Ends the run with one line on standard error and this exit code.
struct Failure : std::runtime_error {
  Failure(ExitCode exit, const std::string& message) : std::runtime_error(message), code(exit) {}
  ExitCode code;
};

/// A wrong command line; names the option and what was expected.
struct UsageFailure : Failure {
  explicit UsageFailure(const std::string& message) : Failure(kUsage, message) {}
};

/// Something wrong with one file, which the message begins with.
struct FileFailure : Failure {
  FileFailure(const std::string& path, const std::string& what)
      : Failure(kInputOutput, "'" + path + "': " + what) {}
};

}  // namespace cli
