#pragma once

#include <stdexcept>
#include <string>

namespace cli {

/// The exit codes of the process, as --help-all documents them. A run that a signal stopped returns
/// kSignal plus the signal's number, as a shell reports a program that was ended by it.
enum ExitCode { kRegistered = 0, kUsage = 1, kInputOutput = 2, kNotRegistered = 3, kSignal = 128 };

/// Ends the run with one line on standard error and this exit code.
struct Failure : std::runtime_error {
  Failure(int exit, const std::string& message) : std::runtime_error(message), code(exit) {}
  int code;
};

/// Reports a wrong command line; the message names the option and what was expected.
struct UsageFailure : Failure {
  explicit UsageFailure(const std::string& message) : Failure(kUsage, message) {}
};

/// Reports a fault in one file; the message begins with its path.
struct FileFailure : Failure {
  FileFailure(const std::string& path, const std::string& what)
      : Failure(kInputOutput, "'" + path + "': " + what) {}
};

}  // namespace cli
