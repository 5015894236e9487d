/* Tests a cloud that is preprocessed once for many registrations: the bits do not change. */
#include <stdlib.h>
#include <string.h>

#include "bumpy_pair.h"
#include "check.h"
#include "cloud_of.h"

static void same(const emtr_result* a, const emtr_result* b) {
  CHECK(memcmp(a->transformation, b->transformation, sizeof a->transformation) == 0);
  CHECK(a->fitness == b->fitness && a->fitness_gap == b->fitness_gap);
  CHECK(a->leaf_dense == b->leaf_dense && a->leaf_sparse == b->leaf_sparse);
  CHECK(a->queries_evaluation == b->queries_evaluation);
  CHECK(a->points_source == b->points_source && a->dropped_source == b->dropped_source);
  CHECK(a->points_target == b->points_target && a->dropped_target == b->dropped_target);
  CHECK(a->normalization_scale == b->normalization_scale);
}

static void one_against_many(void) {
  bumpy_pair pair, other;
  emtr_cloud source, target, third;
  emtr_preprocessed *a = NULL, *b = NULL, *c = NULL;
  emtr_preprocessed_info info;
  emtr_problem* problem = NULL;
  emtr_result *plain[3] = {NULL, NULL, NULL}, *reused[3] = {NULL, NULL, NULL}, *solved = NULL;
  size_t i;
  if (bumpy_pair_make(&pair, 2, 4000, 1.0) || bumpy_pair_make(&other, 2, 3000, 2.5)) exit(1);
  pair.source[7] = NAN;
  source = cloud_of(pair.source, pair.count);
  target = cloud_of(pair.target, pair.count);
  third = cloud_of(other.source, other.count);
  CHECK_OK(emtr_register(&source, &target, NULL, NULL, NULL, &plain[0]));
  CHECK_OK(emtr_register(&third, &target, NULL, NULL, NULL, &plain[1]));
  CHECK_OK(emtr_register(&target, &source, NULL, NULL, NULL, &plain[2]));

  CHECK_OK(emtr_preprocess(&source, "source", 1, &a));
  CHECK_OK(emtr_preprocess(&target, NULL, 0, &b));
  CHECK_OK(emtr_preprocess(&third, NULL, 2, &c));
  CHECK_OK(emtr_preprocessed_describe(a, &info, sizeof info));
  CHECK(info.points == 3999 && info.dropped == 1 && info.base_points == 3999);
  CHECK(info.radius == plain[0]->normalization_scale ||
        info.radius < plain[0]->normalization_scale);
  CHECK(memcmp(info.center, plain[0]->center_source, sizeof info.center) == 0);
  /* the library does not refer to the caller's memory any more */
  for (i = 0; i < 3 * pair.count; ++i) pair.target[i] = pair.source[i] = 0;
  CHECK_OK(emtr_register_preprocessed(a, b, NULL, NULL, NULL, &reused[0]));
  CHECK_OK(emtr_register_preprocessed(c, b, NULL, NULL, NULL, &reused[1]));
  CHECK_OK(emtr_register_preprocessed(b, a, NULL, NULL, NULL, &reused[2]));
  for (i = 0; i < 3; ++i) {
    if (!plain[i] || !reused[i]) exit(1);
    same(plain[i], reused[i]);
    emtr_result_free(reused[i]);
  }

  CHECK_OK(emtr_problem_create_preprocessed(a, b, NULL, &problem));
  emtr_preprocessed_free(a);
  emtr_preprocessed_free(b);
  emtr_preprocessed_free(c);
  emtr_preprocessed_free(NULL);
  CHECK_OK(emtr_problem_solve(problem, NULL, NULL, &solved));
  if (!solved) exit(1);
  same(plain[0], solved);
  emtr_problem_free(problem);
  emtr_result_free(solved);
  for (i = 0; i < 3; ++i) emtr_result_free(plain[i]);
  bumpy_pair_free(&pair);
  bumpy_pair_free(&other);
}

static int stop(const emtr_progress* progress, void* user) {
  return strcmp(progress->stage, (const char*)user) == 0;
}

/* A registration caches its preprocessing, and uses what another one cached. */
static void cached(void) {
  bumpy_pair pair;
  emtr_cloud source, target;
  emtr_preprocessed *a = NULL, *b = NULL, *first;
  emtr_result *plain = NULL, *result = NULL;
  char normalization[] = "normalization";
  if (bumpy_pair_make(&pair, 2, 3000, 1.0)) exit(1);
  source = cloud_of(pair.source, pair.count);
  target = cloud_of(pair.target, pair.count);
  CHECK_OK(emtr_register(&source, &target, NULL, NULL, NULL, &plain));

  CHECK_OK(emtr_register_cached(&source, &a, &target, &b, NULL, stop, normalization, &result));
  CHECK(result && result->reason == EMTR_REASON_INTERRUPTED && a == NULL && b == NULL);
  emtr_result_free(result);
  CHECK_OK(emtr_register_cached(&source, &a, &target, NULL, NULL, NULL, NULL, &result));
  CHECK(a != NULL && b == NULL);
  same(plain, result);
  emtr_result_free(result);
  first = a;
  CHECK_OK(emtr_register_cached(NULL, &a, &target, &b, NULL, NULL, NULL, &result));
  CHECK(a == first && b != NULL);
  same(plain, result);
  emtr_result_free(result);
  CHECK_OK(emtr_register_cached(NULL, &a, NULL, &b, NULL, NULL, NULL, &result));
  same(plain, result);
  emtr_result_free(result);

  CHECK_ERROR(emtr_register_cached(NULL, NULL, NULL, &b, NULL, NULL, NULL, &result),
              EMTR_ERROR_ARGUMENT, "source is null");
  CHECK(result == NULL);
  source.count = 5; /* too few; the error is of the source, and the target was not reached */
  first = NULL;
  CHECK_ERROR(emtr_register_cached(&source, NULL, &target, &first, NULL, NULL, NULL, &result),
              EMTR_ERROR_CLOUD, "source cloud");
  CHECK(result == NULL && first == NULL);
  target.count = 5; /* of two bad clouds the source is named, whichever is read first */
  CHECK_ERROR(emtr_register_cached(&source, NULL, &target, &first, NULL, NULL, NULL, &result),
              EMTR_ERROR_CLOUD, "source cloud");
  CHECK(result == NULL && first == NULL);
  emtr_preprocessed_free(a);
  emtr_preprocessed_free(b);
  emtr_result_free(plain);
  bumpy_pair_free(&pair);
}

static void wrong_calls(void) {
  static const float few[27];
  bumpy_pair pair;
  emtr_cloud cloud, bad = cloud_of(few, 9);
  emtr_preprocessed *good = NULL, *none = NULL;
  emtr_preprocessed_info info;
  emtr_problem* problem = NULL;
  emtr_result* result = NULL;
  emtr_settings settings;
  char stage[] = "normalization";
  if (bumpy_pair_make(&pair, 3, 1000, 1.0)) exit(1);
  cloud = cloud_of(pair.source, pair.count);
  CHECK_OK(emtr_preprocess(&cloud, NULL, 0, &good));
  none = good;
  CHECK_ERROR(emtr_preprocess(&bad, "model", 0, &none), EMTR_ERROR_CLOUD, "model cloud: 9 finite");
  CHECK(none == NULL);
  CHECK_ERROR(emtr_preprocess(NULL, NULL, 0, &none), EMTR_ERROR_ARGUMENT, "cloud is null");
  CHECK_ERROR(emtr_preprocess(&cloud, NULL, 0, NULL), EMTR_ERROR_ARGUMENT, "preprocessed is null");
  CHECK_ERROR(emtr_preprocess(&cloud, NULL, -1, &none), EMTR_ERROR_SETTING, "threads");
  CHECK_ERROR(emtr_preprocessed_describe(NULL, &info, sizeof info), EMTR_ERROR_ARGUMENT,
              "preprocessed is null");
  CHECK_ERROR(emtr_preprocessed_describe(good, NULL, sizeof info), EMTR_ERROR_ARGUMENT,
              "info is null");
  CHECK_ERROR(emtr_preprocessed_describe(good, &info, 8), EMTR_ERROR_ARGUMENT, "size is 8");
  CHECK_ERROR(emtr_register_preprocessed(NULL, good, NULL, NULL, NULL, &result),
              EMTR_ERROR_ARGUMENT, "source is null");
  CHECK_ERROR(emtr_register_preprocessed(good, NULL, NULL, NULL, NULL, &result),
              EMTR_ERROR_ARGUMENT, "target is null");
  CHECK_ERROR(emtr_register_preprocessed(good, good, NULL, NULL, NULL, NULL), EMTR_ERROR_ARGUMENT,
              "result is null");
  CHECK_OK(emtr_settings_init(&settings, sizeof settings, NULL));
  settings.population = 1;
  CHECK_ERROR(emtr_problem_create_preprocessed(good, good, &settings, &problem), EMTR_ERROR_SETTING,
              "population");
  CHECK(problem == NULL);
  CHECK_OK(emtr_register_preprocessed(good, good, NULL, stop, stage, &result));
  CHECK(result && result->reason == EMTR_REASON_INTERRUPTED);
  emtr_result_free(result);
  emtr_preprocessed_free(good);
  bumpy_pair_free(&pair);
}

int main(void) {
  one_against_many();
  cached();
  wrong_calls();
  return check_result();
}
