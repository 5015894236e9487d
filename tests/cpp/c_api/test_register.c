/* Tests one call from clouds to result: pose, reproducibility, progress, viewpoints, residuals. */
#include <fenv.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bumpy_pair.h"
#include "check.h"
#include "cloud_of.h"

static emtr_result* run(const bumpy_pair* pair, const emtr_settings* settings,
                        emtr_progress_fn progress, void* user) {
  const emtr_cloud source = cloud_of(pair->source, pair->count);
  const emtr_cloud target = cloud_of(pair->target, pair->count);
  emtr_result* result = NULL;
  CHECK_OK(emtr_register(&source, &target, settings, progress, user, &result));
  if (!result) exit(1); /* the check has reported it */
  return result;
}

static emtr_settings preset(const char* name) {
  emtr_settings settings;
  CHECK_OK(emtr_settings_init(&settings, sizeof settings, name));
  return settings;
}

static void same_pose(const emtr_result* a, const emtr_result* b) {
  CHECK(memcmp(a->transformation, b->transformation, sizeof a->transformation) == 0);
  CHECK(a->fitness == b->fitness && a->fitness_gap == b->fitness_gap);
}

static void the_result_is_whole(const bumpy_pair* pair, const emtr_result* r,
                                const emtr_settings* settings) {
  const double* t = r->transformation;
  const size_t switch_at = (size_t)ceil(settings->switch_fraction * settings->iterations);
  size_t i;
  int row, other, k;
  CHECK(r->size == sizeof(emtr_result));
  CHECK(bumpy_pair_error(pair, t) < 0.05);
  CHECK(r->registered == 1 && r->reason == EMTR_REASON_REGISTERED);
  for (row = 0; row < 3; ++row)
    for (other = 0; other < 3; ++other) {
      double dot = 0;
      for (k = 0; k < 3; ++k) dot += t[4 * row + k] * t[4 * other + k];
      CHECK(fabs(dot - (row == other)) < 1e-12);
    }
  CHECK(t[12] == 0 && t[13] == 0 && t[14] == 0 && t[15] == 1);
  CHECK(r->fitness > 0 && r->fitness < 1 && r->fitness_gap > 0);
  CHECK(r->inlier_ratio_source > 0.3 && r->inlier_ratio_source <= 1);
  CHECK(r->inlier_ratio_target > 0.3 && r->inlier_ratio_target <= 1);
  CHECK(r->inlier_rmse > 0 && r->inlier_rmse < r->leaf_fine * r->normalization_scale);
  CHECK(r->inlier_rmse_plane > 0 && r->inlier_rmse_plane < r->inlier_rmse);
  CHECK(r->overlap_source > 0.5 && r->overlap_source <= 1);
  CHECK(r->overlap_target > 0.5 && r->overlap_target <= 1);
  CHECK(r->points_source == pair->count && r->points_target == pair->count);
  CHECK(r->dropped_source == 0 && r->dropped_target == 0);
  CHECK(r->sparse_source > 0 && r->sparse_source < r->dense_source);
  CHECK(r->sparse_target > 0 && r->sparse_target < r->dense_target);
  CHECK(r->correspondences > 10 && r->tims > r->correspondences && r->tims_pruned < r->tims);
  CHECK(r->queries_evaluation > 0 && r->queries_complement > 0);
  CHECK(r->normalization_scale > 0.5 * pair->unit && r->normalization_scale < 2 * pair->unit);
  CHECK(r->leaf_sparse > r->leaf_dense && r->leaf_dense > 0);
  CHECK(r->seconds_total > 0 && r->seconds_evolution <= r->seconds_total);
  /* with candidates the best pose stays in one place from the first iteration on */
  CHECK(r->iterations ==
        (size_t)(settings->candidates ? 1 + settings->stall_iterations : settings->iterations));
  CHECK(r->seed == 0 && r->threads >= 1);
  CHECK((r->queries_switch > 0) == (r->iterations > switch_at));
  for (i = 1; i < r->iterations; ++i) CHECK(r->history_beta[i] <= r->history_beta[i - 1]);
  /* the first iterations of both presets are sparse, counted as in the published method */
  for (i = 1; i < switch_at && i < r->iterations; ++i)
    CHECK(r->history_alpha[i] <= r->history_alpha[i - 1]);
}

static void by_the_default_preset(const bumpy_pair* pair, const emtr_result* r) {
  const emtr_settings settings = preset("default");
  size_t i;
  int k, j;
  the_result_is_whole(pair, r, &settings);
  CHECK(r->confidence > 0.9 && r->confidence <= 1);
  CHECK(r->surface_fit > 0 && r->surface_fit <= 1 && r->score <= r->surface_fit &&
        r->violation >= 0);
  CHECK(r->seeds > 0 && r->candidates > 0 && r->seconds_candidates > 0);
  for (i = 0; i < r->alternative_count; ++i) {
    CHECK(r->alternatives[i].score <= r->score);
    CHECK(i == 0 || r->alternatives[i].score <= r->alternatives[i - 1].score);
    CHECK(!(bumpy_pair_error(pair, r->alternatives[i].transformation) < 0.05));
  }
  CHECK(r->refined == 1 && r->unconstrained_directions == 0 && r->seconds_refinement > 0);
  for (k = 0; k < 6; ++k) {
    CHECK(r->information[7 * k] > 0);
    for (j = 0; j < k; ++j) {
      const double a = r->information[6 * k + j], b = r->information[6 * j + k];
      CHECK(fabs(a - b) <= 1e-9 * fabs(a));
    }
    CHECK(k == 0 || r->hessian_eigenvalues[k] >= r->hessian_eigenvalues[k - 1]);
  }
  CHECK(r->hessian_eigenvalues[0] > 0 && r->hessian_eigenvalues[5] < 2);
  /* the refinement comes nearer than the search alone */
  CHECK(bumpy_pair_error(pair, r->transformation) < 0.01);
}

static void by_the_paper(const bumpy_pair* pair) {
  const emtr_settings settings = preset("paper");
  emtr_result* r = run(pair, &settings, NULL, NULL);
  int k;
  the_result_is_whole(pair, r, &settings);
  CHECK(isnan(r->confidence) && isnan(r->score) && isnan(r->surface_fit) && isnan(r->violation));
  CHECK(isnan(r->score_gap) && r->seeds == 0 && r->candidates == 0 && r->alternative_count == 0);
  CHECK(!r->used_fallback_search && !r->refined && r->unconstrained_directions == -1);
  CHECK(r->seconds_seeds == 0 && r->seconds_candidates == 0 && r->seconds_refinement == 0);
  for (k = 0; k < 36; ++k) CHECK(isnan(r->information[k]) && isnan(r->hessian_eigenvectors[k]));
  emtr_result_free(r);
}

/* Viewpoints far out on the scanned side of each cloud; the target's frame is the ball's own. */
static void viewpoints(const bumpy_pair* pair) {
  emtr_settings settings = preset("thorough"); /* its fallback search uses viewpoints */
  const double toward[3] = {0.35, 0.0, 0.94};
  double source[3];
  emtr_result *unknown, *known;
  int i, k;
  unknown = run(pair, &settings, NULL, NULL);
  settings.has_viewpoint_source = settings.has_viewpoint_target = 1;
  for (i = 0; i < 3; ++i) {
    source[i] = 20 * pair->unit * toward[i] - pair->pose[4 * i + 3];
    settings.viewpoint_target[i] = 20 * pair->unit * (i == 0 ? -toward[i] : toward[i]);
  }
  for (k = 0; k < 3; ++k)
    for (i = 0; i < 3; ++i) settings.viewpoint_source[k] += pair->pose[4 * i + k] * source[i];
  known = run(pair, &settings, NULL, NULL);
  CHECK(unknown->used_fallback_search && known->used_fallback_search);
  CHECK(known->registered && bumpy_pair_error(pair, known->transformation) < 0.01);
  CHECK(known->score != unknown->score); /* they act */
  emtr_result_free(unknown);
  emtr_result_free(known);
}

static void layout_of_the_input_does_not_matter(const bumpy_pair* pair, const emtr_result* whole) {
  const size_t stride = 3 * sizeof(double) + 5; /* aligned to nothing */
  char* strided = (char*)malloc(pair->count * stride + 1);
  emtr_cloud source = {.stride = stride, .scalar = EMTR_FLOAT64};
  emtr_cloud target = cloud_of(pair->target, pair->count);
  emtr_result* result = NULL;
  size_t i;
  int k;
  if (!strided) exit(1);
  for (i = 0; i < pair->count; ++i)
    for (k = 0; k < 3; ++k) {
      const double value = pair->source[3 * i + (size_t)k];
      memcpy(strided + 1 + i * stride + (size_t)k * sizeof value, &value, sizeof value);
    }
  source.points = strided + 1;
  source.count = pair->count;
  CHECK_OK(emtr_register(&source, &target, NULL, NULL, NULL, &result));
  if (result) same_pose(whole, result);
  emtr_result_free(result);
  free(strided);
}

static void points_that_are_not_finite_are_dropped(bumpy_pair pair) {
  emtr_result* result;
  float* source = (float*)malloc(3 * pair.count * sizeof(float));
  if (!source) exit(1);
  memcpy(source, pair.source, 3 * pair.count * sizeof(float));
  source[0] = (float)NAN;
  source[3 * 7 + 2] = (float)INFINITY;
  pair.source = source;
  result = run(&pair, NULL, NULL, NULL);
  CHECK(result->dropped_source == 2 && result->points_source == pair.count - 2);
  CHECK(result->registered);
  emtr_result_free(result);
  free(source);
}

typedef struct progress_log {
  int calls, iterations, stop_at, in_all;
  char stages[256];
  const char* last;
} progress_log;

static int on_progress(const emtr_progress* progress, void* user) {
  progress_log* seen = (progress_log*)user;
  ++seen->calls;
  if (progress->iteration == 0) {
    if (strcmp(progress->stage, seen->last) != 0) {
      strcat(seen->stages, progress->stage);
      strcat(seen->stages, " ");
      seen->last = progress->stage;
    }
  } else if (progress->iteration != seen->iterations) { /* not a repeated call */
    CHECK(strcmp(progress->stage, "evolution") == 0);
    CHECK(progress->iteration == ++seen->iterations && progress->iterations == seen->in_all);
    CHECK(progress->best_alpha >= 0 && progress->best_beta >= 0);
  }
  return seen->stop_at >= 0 && (progress->iteration == seen->stop_at);
}

static void progress_and_stop(const bumpy_pair* pair, const emtr_result* whole) {
  emtr_settings settings = preset(NULL);
  const int in_all = settings.iterations;
  progress_log all = {0, 0, -1, 0, "", ""}, third = {0, 0, 3, 0, "", ""},
               at_once = {0, 0, 0, 0, "", ""};
  progress_log thorough = {0, 0, -1, 0, "", ""}, paper = {0, 0, -1, 0, "", ""};
  emtr_result* result;
  all.in_all = third.in_all = at_once.in_all = thorough.in_all = in_all;
  result = run(pair, NULL, on_progress, &all);
  same_pose(whole, result);
  CHECK(all.iterations == 1 + settings.stall_iterations);
  CHECK(strcmp(all.stages,
               "normalization downsampling features matching seeds evolution candidates "
               "refinement verdict ") == 0);
  emtr_result_free(result);

  settings = preset("thorough");
  result = run(pair, &settings, on_progress, &thorough);
  CHECK(result->used_fallback_search &&
        strstr(thorough.stages, "candidates fallback_search refinement "));
  emtr_result_free(result);

  settings = preset("paper");
  paper.in_all = settings.iterations;
  result = run(pair, &settings, on_progress, &paper);
  CHECK(paper.iterations == 100);
  CHECK(strcmp(paper.stages, "normalization downsampling features matching evolution verdict ") ==
        0);
  emtr_result_free(result);

  result = run(pair, NULL, on_progress, &third);
  CHECK(result->reason == EMTR_REASON_INTERRUPTED && !result->registered);
  CHECK(result->iterations == 3 && isfinite(result->transformation[0]));
  emtr_result_free(result);

  result = run(pair, NULL, on_progress, &at_once);
  CHECK(at_once.calls == 1 && result->reason == EMTR_REASON_INTERRUPTED && !result->registered);
  CHECK(isnan(result->transformation[0]) && isnan(result->transformation[15]));
  emtr_result_free(result);
}

static void time_limit(const bumpy_pair* pair, const emtr_result* whole) {
  emtr_settings settings = preset(NULL);
  emtr_result* result;
  settings.time_limit = 1e-9;
  result = run(pair, &settings, NULL, NULL);
  CHECK(result->reason == EMTR_REASON_TIME_LIMIT && !result->registered);
  CHECK(isnan(result->transformation[0]) && isnan(result->confidence));
  emtr_result_free(result);
  settings.time_limit = 1e9;
  result = run(pair, &settings, NULL, NULL);
  same_pose(whole, result);
  emtr_result_free(result);
}

/* The caller's rounding mode does not change the bits, and is restored. */
static void rounding(const bumpy_pair* pair, const emtr_result* whole) {
  emtr_result* result;
  CHECK(fesetround(FE_UPWARD) == 0);
  result = run(pair, NULL, NULL, NULL);
  CHECK(fegetround() == FE_UPWARD);
  fesetround(FE_TONEAREST);
  same_pose(whole, result);
  emtr_result_free(result);
}

static void seed_threads_guess(const bumpy_pair* pair, const emtr_result* whole) {
  emtr_settings settings = preset(NULL);
  emtr_result *result, *other;
  settings.threads = 2;
  result = run(pair, &settings, NULL, NULL);
  same_pose(whole, result);
  CHECK(result->threads == 2);
  emtr_result_free(result);

  /* by the swarm alone: the refinement would bring any seed to the same pose */
  settings = preset("paper");
  other = run(pair, &settings, NULL, NULL);
  settings.seed = UINT64_MAX;
  result = run(pair, &settings, NULL, NULL);
  CHECK(result->seed == UINT64_MAX && bumpy_pair_error(pair, result->transformation) < 0.05);
  CHECK(memcmp(other->transformation, result->transformation, sizeof pair->pose) != 0);
  emtr_result_free(result);
  emtr_result_free(other);

  /* two iterations without transfer do not find the pose by themselves */
  settings.iterations = 2;
  settings.transfer = 0;
  result = run(pair, &settings, NULL, NULL);
  CHECK(!(bumpy_pair_error(pair, result->transformation) < 0.05));
  emtr_result_free(result);
  settings.has_guess = 1;
  memcpy(settings.guess, pair->pose, sizeof settings.guess);
  result = run(pair, &settings, NULL, NULL);
  CHECK(bumpy_pair_error(pair, result->transformation) < 0.05);
  emtr_result_free(result);
}

static void residuals(const bumpy_pair* pair, const emtr_result* result) {
  const emtr_cloud source = cloud_of(pair->source, pair->count);
  const emtr_cloud target = cloud_of(pair->target, pair->count);
  const double stretching[16] = {2, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  double *here = malloc(pair->count * sizeof *here), *back = malloc(pair->count * sizeof *back);
  size_t i, near = 0;
  if (!here || !back) exit(1);
  CHECK_OK(emtr_residuals(&source, &target, result->transformation, 2, here, back));
  for (i = 0; i < pair->count; ++i)
    near += here[i] < result->leaf_fine * result->normalization_scale;
  CHECK(fabs((double)near / (double)pair->count - result->overlap_source) < 0.06);
  CHECK_OK(emtr_residuals(&source, &source, NULL, 0, here, NULL));
  for (i = 0; i < pair->count; ++i) CHECK(here[i] == 0);
  CHECK_OK(emtr_residuals(&source, &target, NULL, 0, NULL, NULL));
  CHECK_ERROR(emtr_residuals(NULL, &target, NULL, 0, here, NULL), EMTR_ERROR_ARGUMENT, "source");
  CHECK_ERROR(emtr_residuals(&source, NULL, NULL, 0, here, NULL), EMTR_ERROR_ARGUMENT, "target");
  CHECK_ERROR(emtr_residuals(&source, &target, stretching, 0, here, NULL), EMTR_ERROR_ARGUMENT,
              "transformation");
  CHECK_ERROR(emtr_residuals(&source, &target, NULL, -1, here, NULL), EMTR_ERROR_SETTING,
              "threads");
  free(here);
  free(back);
}

int main(void) {
  bumpy_pair pair, millimeters;
  emtr_result *whole, *result;
  if (bumpy_pair_make(&pair, 1, 4000, 1.0) || bumpy_pair_make(&millimeters, 1, 4000, 1000.0))
    return 1;
  whole = run(&pair, NULL, NULL, NULL);
  by_the_default_preset(&pair, whole);
  by_the_paper(&pair);
  viewpoints(&pair);
  layout_of_the_input_does_not_matter(&pair, whole);
  points_that_are_not_finite_are_dropped(pair);
  progress_and_stop(&pair, whole);
  time_limit(&pair, whole);
  rounding(&pair, whole);
  seed_threads_guess(&pair, whole);
  residuals(&pair, whole);
  emtr_result_free(whole);
  result = run(&millimeters, NULL, NULL, NULL);
  by_the_default_preset(&millimeters, result);
  emtr_result_free(result);
  emtr_result_free(NULL);
  bumpy_pair_free(&pair);
  bumpy_pair_free(&millimeters);
  return check_result();
}
