/* Tests that bad input gives an error that names what is wrong, and never a result. */
#include <math.h>
#include <string.h>

#include "bumpy_pair.h"
#include "check.h"
#include "cloud_of.h"

static bumpy_pair pair;

static void refuse(const emtr_cloud* source, const emtr_cloud* target,
                   const emtr_settings* settings, emtr_status status, const char* word) {
  emtr_result* result = (emtr_result*)&pair; /* the call sets it to null */
  emtr_problem* problem = (emtr_problem*)&pair;
  CHECK_ERROR(emtr_register(source, target, settings, NULL, NULL, &result), status, word);
  CHECK(result == NULL);
  CHECK_ERROR(emtr_problem_create(source, target, settings, &problem), status, word);
  CHECK(problem == NULL);
}

static void clouds(const emtr_cloud* good) {
  float line[3 * 50], point[3 * 50], none[3 * 50];
  emtr_cloud bad;
  int i;
  for (i = 0; i < 150; ++i) {
    line[i] = (float)(i / 3) * (float)(i % 3 + 1);
    point[i] = 4.0f;
    none[i] = (float)NAN;
  }
  bad = cloud_of(pair.source, 9);
  refuse(&bad, good, NULL, EMTR_ERROR_CLOUD, "source");
  refuse(good, &bad, NULL, EMTR_ERROR_CLOUD, "target");
  bad = cloud_of(pair.source, 0);
  refuse(&bad, good, NULL, EMTR_ERROR_CLOUD, "source");
  bad = cloud_of(none, 50);
  refuse(good, &bad, NULL, EMTR_ERROR_CLOUD, "target");
  bad = cloud_of(line, 50);
  refuse(&bad, good, NULL, EMTR_ERROR_CLOUD, "source");
  bad = cloud_of(point, 50);
  refuse(good, &bad, NULL, EMTR_ERROR_CLOUD, "target");
}

static void arguments(const emtr_cloud* good) {
  emtr_cloud bad = *good;
  emtr_result* result = NULL;
  refuse(NULL, good, NULL, EMTR_ERROR_ARGUMENT, "source");
  refuse(good, NULL, NULL, EMTR_ERROR_ARGUMENT, "target");
  CHECK(emtr_register(good, good, NULL, NULL, NULL, NULL) == EMTR_ERROR_ARGUMENT);
  CHECK(emtr_problem_create(good, good, NULL, NULL) == EMTR_ERROR_ARGUMENT);
  CHECK(emtr_problem_solve(NULL, NULL, NULL, &result) == EMTR_ERROR_ARGUMENT);
  bad.points = NULL;
  refuse(&bad, good, NULL, EMTR_ERROR_ARGUMENT, "source");
  bad = *good;
  bad.stride = 11; /* less than one point */
  refuse(good, &bad, NULL, EMTR_ERROR_ARGUMENT, "stride");
  bad = *good;
  bad.scalar = (emtr_scalar)5;
  refuse(&bad, good, NULL, EMTR_ERROR_ARGUMENT, "source");
}

static void settings(const emtr_cloud* good) {
  emtr_settings bad;
  CHECK_OK(emtr_settings_init(&bad, sizeof bad, NULL));
  bad.size = 8;
  refuse(good, good, &bad, EMTR_ERROR_ARGUMENT, "size");
  CHECK_OK(emtr_settings_init(&bad, sizeof bad, NULL));
  bad.population = -3;
  refuse(good, good, &bad, EMTR_ERROR_SETTING, "population");
  CHECK_OK(emtr_settings_init(&bad, sizeof bad, NULL));
  bad.scale_dense = (double)NAN;
  refuse(good, good, &bad, EMTR_ERROR_SETTING, "scale_dense");
  CHECK_OK(emtr_settings_init(&bad, sizeof bad, NULL));
  bad.has_guess = 1; /* all zero: not a rigid transformation */
  refuse(good, good, &bad, EMTR_ERROR_SETTING, "guess");
}

/* Colors that the settings insist on: of a problem as of a registration. */
static void colors(const emtr_cloud* good) {
  emtr_cloud colored = *good, measured = *good;
  emtr_settings on;
  colored.colors = pair.source; /* any numbers will do */
  measured.intensities = pair.source;
  CHECK_OK(emtr_settings_init(&on, sizeof on, NULL));
  on.use_colors = EMTR_ALWAYS;
  refuse(good, &colored, &on, EMTR_ERROR_ARGUMENT, "source cloud: has neither colors");
  refuse(&colored, good, &on, EMTR_ERROR_ARGUMENT, "target cloud: has neither colors");
  refuse(&colored, &measured, &on, EMTR_ERROR_ARGUMENT, "one has colors and the other");
}

int main(void) {
  emtr_cloud good;
  if (bumpy_pair_make(&pair, 3, 500, 1.0)) return 1;
  good = cloud_of(pair.source, pair.count);
  clouds(&good);
  arguments(&good);
  settings(&good);
  colors(&good);
  bumpy_pair_free(&pair);
  return check_result();
}
