/* Tests a problem stage by stage: its arrays, the two tasks, the complement, and its solution. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bumpy_pair.h"
#include "check.h"
#include "cloud_of.h"

static const char* rows_of(const emtr_problem* problem, emtr_array which, size_t columns,
                           size_t* rows) {
  const void* data = NULL;
  size_t got = 0;
  CHECK_OK(emtr_problem_array(problem, which, &data, rows, &got));
  CHECK(data != NULL && got == columns);
  return (const char*)data;
}

static void arrays(const emtr_problem* problem, const emtr_problem_info* info) {
  size_t source, target, rows, tims, i;
  const char* tim;
  const float* points;
  const int32_t* matches;
  rows_of(problem, EMTR_SOURCE_SPARSE, 3, &rows);
  points = (const float*)(const void*)rows_of(problem, EMTR_SOURCE_DENSE, 3, &source);
  CHECK(rows > 50 && rows < source);
  for (i = 0; i < 3 * source; ++i) CHECK(points[i] >= -1.01f && points[i] <= 1.01f);
  rows_of(problem, EMTR_TARGET_SPARSE, 3, &rows);
  rows_of(problem, EMTR_TARGET_DENSE, 3, &target);
  CHECK(rows > 50 && rows < target);
  rows_of(problem, EMTR_SOURCE_NORMALS, 3, &rows);
  CHECK(rows == source);
  rows_of(problem, EMTR_TARGET_NORMALS, 3, &rows);
  CHECK(rows == target);
  rows_of(problem, EMTR_SOURCE_FEATURES, 33, &rows);
  CHECK(rows == source);
  rows_of(problem, EMTR_TARGET_FEATURES, 33, &rows);
  CHECK(rows == target);
  matches = (const int32_t*)(const void*)rows_of(problem, EMTR_CORRESPONDENCES, 2, &rows);
  for (i = 0; i < rows; ++i) {
    CHECK(matches[2 * i] >= 0 && (size_t)matches[2 * i] < source);
    CHECK(matches[2 * i + 1] >= 0 && (size_t)matches[2 * i + 1] < target);
  }
  tim = rows_of(problem, EMTR_TIM_SOURCE, 3, &tims);
  CHECK(tim != rows_of(problem, EMTR_TIM_TARGET, 3, &rows));
  CHECK(tims == rows && tims == info->tims - info->tims_pruned);
}

static void tasks(emtr_problem* problem, const bumpy_pair* pair, const emtr_problem_info* info) {
  double particles[2][6], rotations[2][3], sparse[2], dense[2], beta[2], t[3], back[16];
  size_t rows;
  const uint64_t before = emtr_problem_queries(problem);
  int k;
  CHECK_OK(emtr_transformation_to_particle(problem, pair->pose, particles[0]));
  CHECK_OK(emtr_particle_to_transformation(problem, particles[0], back));
  for (k = 0; k < 16; ++k) CHECK(fabs(back[k] - pair->pose[k]) < 1e-9);

  /* the true pose first, then a pose rotated from it by one radian */
  memcpy(particles[1], particles[0], sizeof particles[0]);
  particles[1][0] += 1.0;
  memcpy(rotations[0], particles[0], sizeof rotations[0]);
  memcpy(rotations[1], particles[1], sizeof rotations[1]);
  CHECK_OK(emtr_task_alpha_evaluate(problem, EMTR_RESOLUTION_SPARSE, particles[0], 2, sparse));
  rows_of(problem, EMTR_SOURCE_SPARSE, 3, &rows);
  CHECK(emtr_problem_queries(problem) - before == 2 * rows);
  CHECK_OK(emtr_task_alpha_evaluate(problem, EMTR_RESOLUTION_DENSE, particles[0], 2, dense));
  CHECK_OK(emtr_task_beta_evaluate(problem, rotations[0], 2, beta));
  CHECK(sparse[0] >= 0 && sparse[0] < sparse[1] && sparse[1] <= (double)rows);
  CHECK(dense[0] >= 0 && dense[0] < dense[1]);
  CHECK(beta[0] >= 0 && beta[0] < beta[1]);

  CHECK_OK(emtr_complement(problem, rotations[0], t));
  for (k = 0; k < 3; ++k) CHECK(fabs(t[k] - particles[0][3 + k]) < 0.05);
  CHECK(info->tau > 0 && info->c_sparse > info->c_dense && info->c_dense > 0);
}

static void wrong_calls(emtr_problem* problem) {
  const void* data;
  size_t rows, columns;
  double fitness, particle[6] = {0, 0, 0, 0, 0, 0}, matrix[16] = {0};
  CHECK(emtr_problem_array(problem, (emtr_array)99, &data, &rows, &columns) == EMTR_ERROR_ARGUMENT);
  CHECK(emtr_problem_array(NULL, EMTR_SOURCE_DENSE, &data, &rows, &columns) == EMTR_ERROR_ARGUMENT);
  CHECK(emtr_task_alpha_evaluate(problem, (emtr_resolution)7, particle, 1, &fitness) ==
        EMTR_ERROR_ARGUMENT);
  CHECK(emtr_task_alpha_evaluate(problem, EMTR_RESOLUTION_DENSE, NULL, 1, &fitness) ==
        EMTR_ERROR_ARGUMENT);
  CHECK(emtr_task_beta_evaluate(problem, particle, 1, NULL) == EMTR_ERROR_ARGUMENT);
  CHECK(emtr_complement(NULL, particle, particle) == EMTR_ERROR_ARGUMENT);
  CHECK(emtr_transformation_to_particle(problem, matrix, particle) != EMTR_OK); /* no rotation */
  CHECK(emtr_problem_describe(problem, NULL, sizeof(emtr_problem_info)) == EMTR_ERROR_ARGUMENT);
}

int main(void) {
  bumpy_pair pair;
  emtr_cloud source, target;
  emtr_problem* problem = NULL;
  emtr_problem_info info;
  emtr_settings by_all_points;
  emtr_result *at_once = NULL, *solved = NULL;
  size_t i;
  if (bumpy_pair_make(&pair, 2, 4000, 1.0)) return 1;
  source = cloud_of(pair.source, pair.count);
  target = cloud_of(pair.target, pair.count);
  CHECK_OK(emtr_settings_init(&by_all_points, sizeof by_all_points, "default"));
  by_all_points.coarse_points = 0;
  CHECK_OK(emtr_register(&source, &target, &by_all_points, NULL, NULL, &at_once));
  CHECK_OK(emtr_problem_create(&source, &target, NULL, &problem));
  if (!problem || !at_once) return 1;
  CHECK_ERROR(emtr_problem_describe(problem, &info, 0), EMTR_ERROR_ARGUMENT, "size is 0");
  CHECK_OK(emtr_problem_describe(problem, &info, sizeof info));
  arrays(problem, &info);
  tasks(problem, &pair, &info);
  wrong_calls(problem);

  /* the library does not refer to the caller's memory any more */
  for (i = 0; i < 3 * pair.count; ++i) pair.target[i] = 0;
  CHECK_OK(emtr_problem_solve(problem, NULL, NULL, &solved));
  if (!solved) return 1;
  CHECK(memcmp(at_once->transformation, solved->transformation, sizeof pair.pose) == 0);
  CHECK(solved->registered && bumpy_pair_error(&pair, solved->transformation) < 0.05);
  CHECK(solved->queries_evaluation == at_once->queries_evaluation);
  emtr_result_free(solved);
  emtr_result_free(at_once);
  emtr_problem_free(problem);
  emtr_problem_free(NULL);
  bumpy_pair_free(&pair);
  return check_result();
}
