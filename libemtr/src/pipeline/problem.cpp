#include "pipeline/problem.h"

#include "pipeline/problem_stages.h"
#include "pipeline/progress.h"
#include "preprocessing/extrusion.h"
#include "priors/make_prior.h"
#include "settings/choices.h"
#include "settings/validation.h"
#include "util/error.h"

namespace emtr {
namespace {

Settings without_user_memory(Settings settings) {
  settings.correspondences = nullptr;
  settings.correspondence_count = 0;
  return settings;
}

/// Runs the stages before the search. `user`: the settings with the user's correspondences.
void run_stages(InputCloud& source, InputCloud& target, const Settings& user, Stages stages,
                Progress& progress, Problem& problem) {
  const Settings& settings = problem.settings;

  progress.enter(Stage::Normalization);
  problem.pair = normalize(source, target, user);
  problem.prior = make_prior(settings, problem.pair.normalization);
  extrude_flat_pair(problem.pair, settings);
  if (problem.pair.extruded && settings.use_colors == When::Always)
    throw Error(EMTR_ERROR_ARGUMENT,
                "clouds: flat across the axis, so that their outlines are registered and colors "
                "cannot count; expected use_colors off or auto");

  load_user_matches(user, problem);
  if (problem.user_matches.matches.size() && settings.seeds > 0 && settings.candidates > 0 &&
      stages != Stages::Matches) {
    progress.enter(Stage::Seeds);
    find_match_poses(problem);
    if (problem.matches_decide && stages == Stages::Needed) return;
  }

  progress.enter(Stage::Downsampling);
  problem.downsampled = downsample(problem.pair, settings);

  progress.enter(Stage::Features);
  load_user_keypoints(problem);
  describe_clouds(problem);

  progress.enter(Stage::Matching);
  match_clouds(problem);
  if (stages == Stages::Matches) return;
  make_tasks_and_surfaces(find_viewpoints(problem), stages, problem);

  if (settings.seeds == 0) return;
  progress.enter(Stage::Seeds);
  find_seeds(problem);
}

}  // namespace

std::unique_ptr<const Problem> make_problem(InputCloud& source, InputCloud& target,
                                            const Settings& settings, CancellationToken& token,
                                            Stages stages, const StageSeconds& seconds) {
  auto problem = std::make_unique<Problem>();
  problem->seconds = seconds;
  problem->settings = without_user_memory(settings);
  validate(problem->settings);
  if (!(settings.scale == ScaleSearched::Fixed))
    throw Error(EMTR_ERROR_SETTING,
                "setting 'scale': a problem has one scale; a registration can search it");
  const CancellationScope scope(&token);
  try {
    Progress progress(token, 0, problem->seconds);
    run_stages(source, target, settings, stages, progress, *problem);
  } catch (const Cancelled&) {
    problem->stopped = true;
  }
  return problem;
}

}  // namespace emtr
