#include "pipeline/registration.h"

#include <utility>

#include "kernels/kernels.h"
#include "pipeline/coarse_search.h"
#include "pipeline/progress.h"
#include "pipeline/require_colors.h"
#include "pipeline/rival_results.h"
#include "pipeline/scale_search.h"
#include "pipeline/small_in_large.h"
#include "pipeline/unknown_scale.h"
#include "settings/choices.h"
#include "util/error.h"
#include "util/stopwatch.h"

namespace emtr {
namespace {

/// One run: what register_clouds() was given, and the seconds of the preprocessing.
struct Run {
  InputCloud &source, &target;
  const Settings& settings;
  CancellationToken& token;
  StageSeconds seconds;
};

/// Preprocesses both clouds and compares them; calls them alike when it is cancelled.
Sizes sizes_of(Run& run) {
  const CancellationScope scope(&run.token);
  try {
    Progress progress(run.token, 0, run.seconds);
    progress.enter(Stage::Normalization);
    preprocess(run.source, run.target, run.settings);
    return compare_sizes(*run.source.preprocessed, *run.target.preprocessed, run.settings);
  } catch (const Cancelled&) {
    return Sizes::Alike;
  }
}

std::unique_ptr<Result> register_whole(Run& run) {
  return register_coarse_to_fine(run.source, run.target, run.settings, run.token, run.seconds);
}

/// Returns the result of the parts of the larger cloud; null when none is worth a look, or when the
/// run is stopped before there is one.
std::unique_ptr<Result> register_parts(Run& run) {
  const CancellationScope scope(&run.token);
  try {
    return register_small_in_large(run.source, run.target, run.settings, run.token);
  } catch (const Cancelled&) {
    return nullptr;
  }
}

/// Registers both clouds as they are; null when the smaller one vanishes at the leaf that serves
/// both, which is no error where the parts have a leaf of their own.
std::unique_ptr<Result> register_whole_if_possible(Run& run) {
  try {
    return register_whole(run);
  } catch (const Error& error) {
    if (error.status() != EMTR_ERROR_CLOUD) throw;
    return nullptr;
  }
}

bool is_surer(const std::unique_ptr<Result>& a, const std::unique_ptr<Result>& b) {
  return a && (!b || a->confidence > b->confidence);
}

/// Counts what was found in one way among the answers of the other.
void weigh_each_other(const Run& run, Result* parts, Result* whole) {
  if (!parts || !whole) return;
  const PreprocessedCloud &source = *run.source.preprocessed, &target = *run.target.preprocessed;
  const bool small_is_source = source.radius < target.radius;
  const SmallCloud small{small_is_source ? source : target, small_is_source};
  const Result alone = *parts;
  weigh_rivals({whole}, small, run.settings.minimum_confidence, *parts);
  weigh_rivals({&alone}, small, run.settings.minimum_confidence, *whole);
}

/// Registers in both ways, unless the first one convinces, and returns the surer result.
std::unique_ptr<Result> register_both_ways(Run& run, Sizes sizes) {
  const auto convinces = [&](const std::unique_ptr<Result>& result) {
    const bool sure =
        result && result->registered && result->confidence >= run.settings.fallback_confidence;
    return sure || (result && run.token.cancelled());
  };
  std::unique_ptr<Result> parts, whole;
  if (sizes == Sizes::VeryDifferent) parts = register_parts(run);
  if (convinces(parts)) return parts;
  whole = parts ? register_whole_if_possible(run) : register_whole(run);
  if (convinces(whole)) return whole;
  if (sizes == Sizes::Different) parts = register_parts(run);
  weigh_each_other(run, parts.get(), whole.get());
  return is_surer(parts, whole) ? std::move(parts) : std::move(whole);
}

}  // namespace

std::unique_ptr<Result> register_clouds(InputCloud& source, InputCloud& target,
                                        const Settings& settings, CancellationToken& token) {
  select_kernels();  // an instruction set that is not there is refused before the clouds are read
  Run run{source, target, settings, token, {}};
  Stopwatch stopwatch;
  const Sizes sizes = sizes_of(run);
  if (source.preprocessed && target.preprocessed)  // not stopped before
    require_colors(settings, *source.preprocessed, *target.preprocessed);
  const bool fixed = settings.scale == ScaleSearched::Fixed;
  if (!fixed && !(source.preprocessed && target.preprocessed)) {  // stopped before it began
    const Settings rigid = settings_at_scale(settings, 1);
    Run stopped{source, target, rigid, token, run.seconds};
    return register_whole(stopped);
  }
  if (fixed && sizes == Sizes::Alike) return register_whole(run);
  auto result = fixed ? register_both_ways(run, sizes)
                      : register_unknown_scale(source, target, settings, token, run.seconds);
  // Counts all that is not in the stages of the result as search.
  // NOLINTNEXTLINE(clang-analyzer-core.NullDereference): without one of parts there is the whole's
  double& search = fixed ? result->seconds_fallback_search : result->seconds_scale_search;
  const double seconds = stopwatch.lap();
  search += seconds - result->seconds_total;
  result->seconds_total = seconds;
  return result;
}

}  // namespace emtr
