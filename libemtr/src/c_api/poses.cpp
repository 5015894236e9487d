#include <emtr/emtr.h>

#include <string>
#include <vector>

#include "c_api/arguments.h"
#include "c_api/guarded.h"
#include "c_api/handles.h"
#include "pipeline/make_result.h"
#include "pipeline/search_stages.h"
#include "pipeline/solve.h"
#include "util/thread_team.h"

using emtr::checked;
using emtr::guarded;
using emtr::required;

namespace {

/// Returns the user's poses in the normalized frame.
std::vector<emtr::Rigid> normalized(const emtr::Problem& problem, const double* transformations,
                                    std::size_t count) {
  required(transformations, "transformations");
  std::vector<emtr::Rigid> poses;
  for (std::size_t i = 0; i < count; ++i) {
    const double* matrix = transformations + 16 * i;
    if (!emtr::is_rigid(matrix))
      throw emtr::Error(EMTR_ERROR_ARGUMENT, "transformations: row " + std::to_string(i) +
                                                 ": expected a row-major 4x4 of a rotation, a "
                                                 "translation and (0, 0, 0, 1)");
    poses.push_back(problem.pair.normalization.to_normalized(emtr::from_matrix(matrix)));
  }
  return poses;
}

void require_some(std::size_t count) {
  if (count == 0) throw emtr::Error(EMTR_ERROR_ARGUMENT, "count is 0, expected at least one pose");
}

}  // namespace

extern "C" {

emtr_status emtr_problem_solve_from(emtr_problem* problem, const double* transformations,
                                    size_t count, emtr_progress_fn progress, void* user,
                                    emtr_result** result) {
  return guarded([&] {
    required(result, "result") = nullptr;
    const emtr::Problem& p = *checked(problem).data;
    require_some(count);
    const std::vector<emtr::Rigid> poses = normalized(p, transformations, count);
    emtr::CancellationToken token(emtr::progress_function(progress, user), p.settings.time_limit);
    *result = emtr::solve(p, token, &poses).release();
  });
}

emtr_status emtr_problem_score(const emtr_problem* problem, const double* transformations,
                               size_t count, emtr_alternative* scored) {
  return guarded([&] {
    const emtr::Problem& p = *checked(problem).data;
    if (count == 0) return;
    const std::vector<emtr::Rigid> poses = normalized(p, transformations, count);
    required(scored, "scored");
    if (!p.surfaces)
      throw emtr::Error(EMTR_ERROR_SETTING,
                        "candidates is 0, or the correspondences decide: poses have no score");
    const int threads = emtr::thread_count(p.settings);
    std::vector<emtr::Ranking::Scratch> scratch(static_cast<std::size_t>(threads));
    emtr::ThreadTeam::with(threads, [&](emtr::ThreadTeam& team) {
      team.parallel(count, [&](std::size_t i, std::size_t thread) {
        const emtr::Ranking::Value value =
            p.surfaces->ranking().evaluate(poses[i], scratch[thread]);
        const emtr::Candidate candidate{poses[i], value.fit, value.violation, value.score};
        emtr::write_alternative(p, candidate, scored[i]);
      });
    });
  });
}

emtr_status emtr_problem_refine(const emtr_problem* problem, const double* transformations,
                                size_t count, double* refined) {
  return guarded([&] {
    const emtr::Problem& p = *checked(problem).data;
    if (count == 0) return;
    const std::vector<emtr::Rigid> poses = normalized(p, transformations, count);
    required(refined, "refined");
    const emtr::FineSurfaces fine =
        emtr::fine_surfaces(p.pair, p.settings.refine_leaf, p.downsampled.leaf_dense, p.kernels,
                            emtr::thread_count(p.settings));
    for (std::size_t i = 0; i < count; ++i) {
      const emtr::Refined found = emtr::refine(fine, emtr::admissible_pose(p, poses[i]), p.settings,
                                               p.kernels, p.prior.get());
      emtr::to_matrix(p.pair.normalization.to_user(found.pose), refined + 16 * i);
    }
  });
}

}  // extern "C"
