/* Tests what is done with poses that were found elsewhere: scored, refined, judged. */
#include <math.h>
#include <string.h>

#include "bumpy_pair.h"
#include "check.h"
#include "cloud_of.h"

/* Writes the true pose, after the source was rotated by `angle` about its z axis. */
static void off(const bumpy_pair* pair, double angle, double pose[16]) {
  const double c = cos(angle), s = sin(angle);
  int row;
  memcpy(pose, pair->pose, sizeof pair->pose);
  for (row = 0; row < 3; ++row) {
    pose[4 * row] = c * pair->pose[4 * row] + s * pair->pose[4 * row + 1];
    pose[4 * row + 1] = c * pair->pose[4 * row + 1] - s * pair->pose[4 * row];
  }
}

static int count_calls(const emtr_progress* progress, void* user) {
  *(int*)user += strcmp(progress->stage, "candidates") == 0;
  return 0;
}

static void wrong_calls(emtr_problem* problem, double* poses) {
  emtr_result* result = (emtr_result*)(void*)poses; /* to see that it becomes null */
  emtr_alternative scored[2];
  double refined[32];
  CHECK(emtr_problem_solve_from(NULL, poses, 1, NULL, NULL, &result) == EMTR_ERROR_ARGUMENT);
  CHECK(result == NULL);
  CHECK(emtr_problem_solve_from(problem, NULL, 1, NULL, NULL, &result) == EMTR_ERROR_ARGUMENT);
  CHECK_ERROR(emtr_problem_solve_from(problem, poses, 0, NULL, NULL, &result), EMTR_ERROR_ARGUMENT,
              "at least one pose");
  CHECK(emtr_problem_solve_from(problem, poses, 1, NULL, NULL, NULL) == EMTR_ERROR_ARGUMENT);
  CHECK(emtr_problem_score(problem, poses, 1, NULL) == EMTR_ERROR_ARGUMENT);
  CHECK(emtr_problem_refine(problem, poses, 1, NULL) == EMTR_ERROR_ARGUMENT);
  CHECK_OK(emtr_problem_score(problem, NULL, 0, NULL));
  CHECK_OK(emtr_problem_refine(problem, NULL, 0, NULL));
  poses[16] = 2; /* the second is no rotation */
  CHECK_ERROR(emtr_problem_solve_from(problem, poses, 2, NULL, NULL, &result), EMTR_ERROR_ARGUMENT,
              "row 1");
  CHECK_ERROR(emtr_problem_score(problem, poses, 2, scored), EMTR_ERROR_ARGUMENT, "row 1");
  CHECK_ERROR(emtr_problem_refine(problem, poses, 2, refined), EMTR_ERROR_ARGUMENT, "row 1");
}

int main(void) {
  bumpy_pair pair;
  emtr_cloud source, target;
  emtr_settings settings;
  emtr_problem* problem = NULL;
  emtr_result* result = NULL;
  emtr_alternative scored[2];
  double poses[32], refined[32];
  int calls = 0;
  if (bumpy_pair_make(&pair, 2, 4000, 1.0)) return 1;
  source = cloud_of(pair.source, pair.count);
  target = cloud_of(pair.target, pair.count);
  CHECK_OK(emtr_settings_init(&settings, sizeof settings, "default"));
  settings.seeds = 0;
  settings.fallback_search = EMTR_OFF;
  CHECK_OK(emtr_problem_create(&source, &target, &settings, &problem));
  if (!problem) return 1;

  off(&pair, 1.0, poses);
  off(&pair, 0.03, poses + 16);
  CHECK_OK(emtr_problem_score(problem, poses, 2, scored));
  CHECK(scored[1].score > scored[0].score && scored[1].evidence > scored[0].evidence);
  CHECK(fabs(scored[1].transformation[1] - poses[17]) < 1e-9);

  CHECK_OK(emtr_problem_refine(problem, poses, 2, refined));
  CHECK(bumpy_pair_error(&pair, poses + 16) > 0.02);
  CHECK(bumpy_pair_error(&pair, refined + 16) < 0.01);

  CHECK_OK(emtr_problem_solve_from(problem, poses, 2, count_calls, &calls, &result));
  if (!result) return 1;
  CHECK(result->registered && bumpy_pair_error(&pair, result->transformation) < 0.01);
  CHECK(result->iterations == 0 && result->seeds == 0 && result->queries_evaluation > 0);
  CHECK(calls > 0);
  emtr_result_free(result);

  wrong_calls(problem, poses);
  emtr_problem_free(problem);
  bumpy_pair_free(&pair);
  return check_result();
}
