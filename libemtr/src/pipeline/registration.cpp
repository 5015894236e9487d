#include "pipeline/registration.h"

#include <utility>

#include "pipeline/problem.h"
#include "pipeline/progress.h"
#include "pipeline/small_in_large.h"
#include "pipeline/solve.h"
#include "util/error.h"

namespace emtr {
namespace {

/// One run: what register_clouds() was given, and the seconds of the preprocessing.
struct Run {
  InputCloud &source, &target;
  const Settings& settings;
  CancellationToken& token;
  StageSeconds seconds;
};

std::unique_ptr<Result> register_whole(Run& run) {
  const auto problem =
      make_problem(run.source, run.target, run.settings, run.token, Stages::Needed, run.seconds);
  return solve(*problem, run.token);
}

/// Returns the result of the parts of the larger cloud; null when none is worth a look, or when the
/// run is stopped before there is one.
std::unique_ptr<Result> register_parts(Run& run) {
  const CancellationScope scope(&run.token);
  try {
    Progress progress(run.token, 0, run.seconds);
    progress.enter(Stage::Normalization);
    preprocess(run.source, run.target, run.settings);
    if (!is_small_in_large(*run.source.preprocessed, *run.target.preprocessed, run.settings))
      return nullptr;
    progress.enter(Stage::FallbackSearch);
    return register_small_in_large(run.source, run.target, run.settings, run.token);
  } catch (const Cancelled&) {
    return nullptr;
  }
}

}  // namespace

std::unique_ptr<Result> register_clouds(InputCloud& source, InputCloud& target,
                                        const Settings& settings, CancellationToken& token) {
  Run run{source, target, settings, token, {}};
  auto of_parts = register_parts(run);
  if (!of_parts) return register_whole(run);
  of_parts->seconds_normalization += run.seconds[Stage::Normalization];
  of_parts->seconds_total += run.seconds[Stage::Normalization];
  if (of_parts->registered || token.cancelled()) return of_parts;
  try {
    auto of_whole = register_whole(run);
    return of_whole->confidence > of_parts->confidence ? std::move(of_whole) : std::move(of_parts);
  } catch (const Error& error) {
    // The smaller cloud vanishes at the leaf that serves both; the parts have a leaf of their own.
    if (error.status() != EMTR_ERROR_CLOUD) throw;
    return of_parts;
  }
}

}  // namespace emtr
