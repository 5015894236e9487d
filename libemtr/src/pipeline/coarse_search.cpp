#include "pipeline/coarse_search.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "pipeline/problem.h"
#include "pipeline/rival_results.h"
#include "pipeline/search_stages.h"
#include "pipeline/solve.h"
#include "settings/choices.h"
#include "util/error.h"

namespace emtr {
namespace {

// What tells whether there is doubt; where there is, the finer search has more of each.
constexpr std::int32_t kPopulation = 20, kCandidates = 6;

/// Without candidates there is no confidence, and without seeds the swarm is all that searches. The
/// user's own matches do not get more by more points, and a second search follows in any case where
/// it is asked for.
bool is_asked_for(const Settings& s) {
  return s.coarse_points > s.sparse_points && s.coarse_points < s.dense_points &&
         s.candidates > 0 && s.seeds > 0 && s.correspondence_count == 0 &&
         !(s.fallback_search == When::Always);
}

Settings coarse(Settings settings) {
  settings.dense_points = settings.coarse_points;
  settings.population = std::min(settings.population, kPopulation);
  settings.candidates = std::min(settings.candidates, kCandidates);
  settings.injected_seeds = std::min(settings.injected_seeds, kCandidates);
  settings.fallback_search = static_cast<std::int32_t>(When::Off);
  return settings;
}

/// What the search by few points found.
struct CoarseSearch {
  std::unique_ptr<Result> result;  ///< null where there was no such search
  bool is_decided = false;         ///< the result leaves no doubt, or the run was stopped
  StageSeconds seconds;            ///< what the run has taken by now
};

CoarseSearch search_coarsely(InputCloud& source, InputCloud& target, const Settings& settings,
                             CancellationToken& token, const StageSeconds& seconds) {
  CoarseSearch out;
  out.seconds = seconds;
  if (!is_asked_for(settings)) return out;
  try {
    const auto problem =
        make_problem(source, target, coarse(settings), token, Stages::Needed, seconds);
    const Solution found = search_once(*problem, token);
    out.result = conclude(*problem, found, token);
    out.seconds = found.seconds;
    const bool is_sure =
        out.result->registered && !is_doubtful(*problem, found) && !is_strange(found);
    out.is_decided = found.stopped || is_sure;
  } catch (const Error& error) {
    // A fault of the clouds themselves is found again by the finer search.
    if (error.status() != EMTR_ERROR_CLOUD) throw;
  }
  return out;
}

}  // namespace

std::unique_ptr<Result> register_coarse_to_fine(InputCloud& source, InputCloud& target,
                                                const Settings& settings, CancellationToken& token,
                                                const StageSeconds& seconds) {
  CoarseSearch coarse = search_coarsely(source, target, settings, token, seconds);
  if (coarse.is_decided) return std::move(coarse.result);
  const auto problem =
      make_problem(source, target, settings, token, Stages::Needed, coarse.seconds);
  auto finer = solve(*problem, token);
  const bool has_pose = !std::isnan(finer->scale);
  if (!coarse.result || !is_stopped(*finer) || has_pose) return finer;
  coarse.result->registered = 0;
  coarse.result->reason = finer->reason;
  return std::move(coarse.result);
}

}  // namespace emtr
