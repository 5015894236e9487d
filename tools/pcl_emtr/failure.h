#pragma once

#include <stdexcept>
#include <string>

namespace cli {

/// What the process returns; documented in --help. Stopped by a signal it returns kSignal and that
/// signal's number, as a shell would say of a program that was ended by it.
enum ExitCode { kRegistered = 0, kUsage = 1, kInputOutput = 2, kNotRegistered = 3, kSignal = 128 };

/// Ends the run with one line on standard error and this exit code.
struct Failure : std::runtime_error {
  Failure(int exit, const std::string& message) : std::runtime_error(message), code(exit) {}
  int code;
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
