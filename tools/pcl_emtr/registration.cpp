#include "registration.h"

#include <cmath>

#include "console/progress_line.h"
#include "failure.h"
#include "interrupt.h"
#include "read/color_fields.h"
#include "read/coordinates.h"
#include "report/unit_hint.h"

namespace cli {
namespace {

/// Shows the progress; returns 1, which stops the run, once a signal asked for it.
int on_progress(const emtr_progress* progress, void* line) {
  static_cast<ProgressLine*>(line)->show(*progress);
  return Interrupt::requested() ? 1 : 0;
}

/// Returns what follows `prefix` in a message of the library, or "".
std::string after(const std::string& prefix, const std::string& message) {
  return message.compare(0, prefix.size(), prefix) == 0 ? message.substr(prefix.size()) : "";
}

/// Names the line of the file in place of the row of the array, where the message has one.
[[noreturn]] void fail_correspondences(const CorrespondenceFile& file, const std::string& what) {
  const auto colon = what.find(": ");
  if (what.compare(0, 4, "row ") != 0 || colon == std::string::npos)
    throw FileFailure(file.path, what);
  const auto line = file.lines.at(std::stoul(what.substr(4)));
  throw FileFailure(file.path, "line " + std::to_string(line) + what.substr(colon));
}

/// Translates the library's error: it names "source cloud" and "setting 'guess'", the user knows
/// files.
[[noreturn]] void fail(emtr_status status, const Options& options, const std::string& hint) {
  std::string message = emtr_error_message();
  if (status == EMTR_ERROR_CLOUD && !hint.empty()) message += "; " + hint;
  if (const auto what = after("correspondences: ", message); !what.empty())
    fail_correspondences(options.correspondences, what);
  if (status == EMTR_ERROR_CLOUD || status == EMTR_ERROR_ARGUMENT) {
    if (const auto what = after("source cloud: ", message); !what.empty())
      throw FileFailure(options.source, what);
    if (const auto what = after("target cloud: ", message); !what.empty())
      throw FileFailure(options.target, what);
    throw Failure(kInputOutput, "'" + options.source + "', '" + options.target + "': " + message);
  }
  if (status == EMTR_ERROR_SETTING) {
    if (const auto what = after("setting 'guess' ", message); !what.empty())
      throw FileFailure(options.guess, what);
    throw UsageFailure(message);
  }
  throw Failure(kInputOutput, std::string(emtr_status_text(status)) + ": " + message);
}

}  // namespace

Result run_registration(const CloudFile& source, const CloudFile& target, const Options& options) {
  std::vector<double> source_copy;
  std::vector<double> target_copy;
  emtr_cloud source_points = coordinates(source, source_copy);
  emtr_cloud target_points = coordinates(target, target_copy);
  std::vector<double> source_normals;
  std::vector<double> target_normals;
  options.fields.attach(source, source_points, source_normals);
  options.fields.attach(target, target_points, target_normals);
  ColorFields source_colors;
  ColorFields target_colors;
  if (options.settings.use_colors != EMTR_OFF) {
    attach_colors(source, source_points, source_colors);
    attach_colors(target, target_points, target_colors);
  }

  emtr_result* raw = nullptr;
  emtr_status status;
  {
    const Interrupt interrupt;
    ProgressLine line(options.quiet);
    status =
        emtr_register(&source_points, &target_points, &options.settings, on_progress, &line, &raw);
  }
  if (status != EMTR_OK) fail(status, options, unit_hint(source, target).text);
  Result result(raw);
  for (const double value : result->transformation)
    if (!std::isfinite(value))
      throw Failure(exit_code(*result), std::string("not registered: ") +
                                            emtr_reason_text(result->reason) +
                                            " before any pose was known; nothing is written");
  return result;
}

int exit_code(const emtr_result& result) {
  if (result.reason == EMTR_REASON_INTERRUPTED) return kSignal + Interrupt::number();
  return result.registered ? kRegistered : kNotRegistered;
}

}  // namespace cli
