/* Tests user-provided input: strides, preprocessed clouds, errors. */
#include <stdlib.h>
#include <string.h>

#include "bumpy_pair.h"
#include "check.h"
#include "cloud_of.h"

enum { kCount = 4000, kNumbers = 3 };

/* Holds one scan twice, so that row i of the source is row i of the target. */
typedef struct twins {
  float source[3 * kCount], target[3 * kCount], normals[3 * kCount], rotated[3 * kCount];
  float features[kNumbers * kCount];
  double pose[16];
} twins;

static void make(twins* t) {
  bumpy_pair pair;
  size_t i, k;
  if (bumpy_pair_make(&pair, 4, kCount, 1.0)) exit(1);
  memcpy(t->source, pair.source, sizeof t->source);
  memcpy(t->pose, pair.pose, sizeof t->pose);
  for (i = 0; i < kCount; ++i) {
    const float* p = t->source + 3 * i;
    for (k = 0; k < 3; ++k) {
      const double* row = pair.pose + 4 * k;
      t->target[3 * i + k] = (float)(row[0] * p[0] + row[1] * p[1] + row[2] * p[2] + row[3]);
      t->normals[3 * i + k] = p[k]; /* roughly: away from the center of the ball */
      t->rotated[3 * i + k] = (float)(row[0] * p[0] + row[1] * p[1] + row[2] * p[2]);
    }
    for (k = 0; k < kNumbers; ++k) t->features[kNumbers * i + k] = sinf(5 * p[k]) + p[(k + 1) % 3];
  }
  bumpy_pair_free(&pair);
}

static double error_of(const emtr_result* result, const twins* t) {
  double most = 0;
  size_t i;
  for (i = 0; i < 16; ++i) {
    const double off = fabs(result->transformation[i] - t->pose[i]);
    if (!(off <= most)) most = off;
  }
  return most;
}

static emtr_result* of(const emtr_cloud* source, const emtr_cloud* target,
                       const emtr_settings* settings) {
  emtr_result* result = NULL;
  CHECK_OK(emtr_register(source, target, settings, NULL, NULL, &result));
  if (!result) exit(1);
  return result;
}

/* Checks that preprocessed clouds give the same bits; frees both results. */
static void same_preprocessed(emtr_result* plain, const emtr_cloud* source,
                              const emtr_cloud* target, const emtr_settings* settings) {
  emtr_preprocessed *a = NULL, *b = NULL;
  emtr_result* result = NULL;
  CHECK_OK(emtr_preprocess(source, NULL, 1, &a));
  CHECK_OK(emtr_preprocess(target, NULL, 2, &b));
  CHECK_OK(emtr_register_preprocessed(a, b, settings, NULL, NULL, &result));
  if (!result) exit(1);
  CHECK(memcmp(plain->transformation, result->transformation, sizeof result->transformation) == 0);
  emtr_result_free(plain);
  emtr_result_free(result);
  emtr_preprocessed_free(a);
  emtr_preprocessed_free(b);
}

static void features_and_normals(const twins* t) {
  /* all in one struct for each point, as scanner software stores them */
  typedef struct row {
    char tag;
    double point[3];
    float descriptor[kNumbers];
    double normal[3];
  } row;
  static row rows[kCount];
  emtr_cloud source = cloud_of(t->source, kCount), target = cloud_of(t->target, kCount), wide;
  emtr_settings settings;
  emtr_preprocessed* preprocessed = NULL;
  emtr_preprocessed_info info;
  emtr_result *plain, *result;
  size_t i, k;
  CHECK_OK(emtr_settings_init(&settings, sizeof settings, "fast"));
  source.features = target.features = t->features;
  source.feature_dimension = target.feature_dimension = kNumbers;
  plain = of(&source, &target, &settings);
  CHECK(plain->registered && error_of(plain, t) < 0.01);
  CHECK(plain->correspondences == 1000);

  for (i = 0; i < kCount; ++i)
    for (k = 0; k < 3; ++k) {
      rows[i].point[k] = t->source[3 * i + k];
      rows[i].normal[k] = 7 * t->normals[3 * i + k];
      rows[i].descriptor[k] = t->features[kNumbers * i + k];
    }
  memset(&wide, 0, sizeof wide);
  wide.points = rows[0].point;
  wide.count = kCount;
  wide.scalar = EMTR_FLOAT64;
  wide.features = rows[0].descriptor;
  wide.feature_dimension = kNumbers;
  wide.stride = wide.feature_stride = sizeof(row);
  result = of(&wide, &target, &settings);
  CHECK(memcmp(plain->transformation, result->transformation, sizeof result->transformation) == 0);
  emtr_result_free(result);

  wide.normals = rows[0].normal;
  wide.normal_stride = sizeof(row);
  target.normals = t->rotated;
  result = of(&wide, &target, &settings);
  CHECK(memcmp(plain->transformation, result->transformation, sizeof result->transformation) != 0);
  CHECK(error_of(result, t) < 0.01);
  CHECK_OK(emtr_preprocess(&wide, NULL, 1, &preprocessed));
  CHECK_OK(emtr_preprocessed_describe(preprocessed, &info, sizeof info));
  CHECK(info.normals == 1 && info.keypoints == kCount && info.feature_dimension == kNumbers);
  emtr_preprocessed_free(preprocessed);
  emtr_result_free(plain);
  same_preprocessed(result, &wide, &target, &settings);
}

static void correspondences(const twins* t) {
  const emtr_cloud source = cloud_of(t->source, kCount), target = cloud_of(t->target, kCount);
  int32_t* pairs = malloc(2 * 500 * sizeof *pairs);
  emtr_problem* problem = NULL;
  emtr_settings settings;
  emtr_result *result, *solved = NULL;
  const void* data = NULL;
  size_t rows = 0, columns = 0;
  int32_t i;
  if (!pairs) exit(1);
  for (i = 0; i < 500; ++i) {
    pairs[2 * i] = 8 * i;
    pairs[2 * i + 1] = i % 5 ? (i * 7919 + 11) % kCount : 8 * i;
  }
  CHECK_OK(emtr_settings_init(&settings, sizeof settings, NULL));
  CHECK(settings.correspondences == NULL && settings.correspondence_count == 0);
  settings.correspondences = pairs;
  settings.correspondence_count = 500;
  result = of(&source, &target, &settings);
  CHECK(result->registered && error_of(result, t) < 0.01);
  CHECK(result->correspondences == 500);
  CHECK_OK(emtr_problem_create(&source, &target, &settings, &problem));
  memset(pairs, 0x7f,
         2 * 500 * sizeof *pairs); /* the library does not refer to the caller's memory any more */
  CHECK_OK(emtr_problem_solve(problem, NULL, NULL, &solved));
  CHECK(solved &&
        memcmp(solved->transformation, result->transformation, sizeof result->transformation) == 0);
  CHECK_OK(emtr_problem_array(problem, EMTR_SOURCE_FEATURE_ROWS, &data, &rows, &columns));
  CHECK(rows == 500 && columns == 1 && ((const int32_t*)data)[3] == 24);
  CHECK_OK(emtr_problem_array(problem, EMTR_SOURCE_FEATURE_POINTS, &data, &rows, &columns));
  CHECK(rows == 500 && columns == 3);
  CHECK_OK(emtr_problem_array(problem, EMTR_CORRESPONDENCES, &data, &rows, &columns));
  CHECK(rows == 500 && columns == 2);
  CHECK_OK(emtr_problem_array(problem, EMTR_SOURCE_FEATURES, &data, &rows, &columns));
  CHECK(rows == 0);
  emtr_problem_free(problem);
  emtr_result_free(solved);
  for (i = 0; i < 500; ++i) {
    pairs[2 * i] = 8 * i;
    pairs[2 * i + 1] = i % 5 ? (i * 7919 + 11) % kCount : 8 * i;
  }
  same_preprocessed(result, &source, &target, &settings);
  free(pairs);
}

static void errors(const twins* t) {
  emtr_cloud source = cloud_of(t->source, kCount), target = cloud_of(t->target, kCount);
  const int32_t pairs[] = {0, 0, 1, 1, 2, kCount};
  emtr_settings settings;
  emtr_preprocessed* preprocessed = NULL;
  emtr_result* result = NULL;
  CHECK_OK(emtr_settings_init(&settings, sizeof settings, NULL));
  settings.correspondence_count = 3;
  CHECK_ERROR(emtr_register(&source, &target, &settings, NULL, NULL, &result), EMTR_ERROR_ARGUMENT,
              "correspondences: null");
  settings.correspondences = pairs;
  CHECK_ERROR(emtr_register(&source, &target, &settings, NULL, NULL, &result), EMTR_ERROR_ARGUMENT,
              "correspondences: row 2: target point 4000, expected 0 to 3999");
  settings.correspondence_count = 2;
  CHECK_ERROR(emtr_register(&source, &target, &settings, NULL, NULL, &result), EMTR_ERROR_ARGUMENT,
              "2 different ones, expected at least 3");
  source.features = t->features;
  source.feature_dimension = kNumbers;
  CHECK_ERROR(emtr_register(&source, &target, NULL, NULL, NULL, &result), EMTR_ERROR_ARGUMENT,
              "features are given for the source cloud only");
  target.features = t->features;
  target.feature_dimension = 2;
  CHECK_ERROR(emtr_register(&source, &target, NULL, NULL, NULL, &result), EMTR_ERROR_ARGUMENT,
              "3 numbers in the source cloud and 2 in the target cloud");
  source.feature_stride = 4;
  CHECK_ERROR(emtr_preprocess(&source, "left", 1, &preprocessed), EMTR_ERROR_ARGUMENT,
              "left cloud: feature_stride is 4 bytes, expected 0 or at least 12");
  CHECK(preprocessed == NULL && result == NULL);
}

int main(void) {
  static twins t;
  make(&t);
  features_and_normals(&t);
  correspondences(&t);
  errors(&t);
  return check_result();
}
