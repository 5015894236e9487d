/* Tests that calls without a progress function ask the interrupt function of their thread. */
#include <stdlib.h>

#include "bumpy_pair.h"
#include "check.h"
#include "cloud_of.h"

typedef struct caller {
  int asked;
  int end;                 /* the answer */
  const emtr_cloud* cloud; /* preprocessed within the function, unless null */
} caller;

static int ask(void* user) {
  caller* self = user;
  ++self->asked;
  if (self->cloud) {
    emtr_preprocessed* preprocessed = NULL;
    CHECK_OK(emtr_preprocess(self->cloud, NULL, 1, &preprocessed));
    emtr_preprocessed_free(preprocessed);
  }
  return self->end;
}

static int go_on(const emtr_progress* progress, void* user) {
  (void)progress;
  (void)user;
  return 0;
}

/* Each call takes far longer than the time between two questions. */
static void long_calls_end(void) {
  enum { kMany = 3000000, kParticles = 20000 };
  caller self = {0, 1, NULL};
  bumpy_pair pair;
  emtr_preprocessed* preprocessed = (emtr_preprocessed*)&self;
  emtr_problem* problem = NULL;
  float* points = malloc(3 * kMany * sizeof *points);
  double* numbers = calloc(6 * kParticles, sizeof *numbers);
  double* out = malloc(kMany * sizeof *out);
  emtr_cloud many, few;
  unsigned random = 1;
  size_t i;
  if (!points || !numbers || !out || bumpy_pair_make(&pair, 2, 4000, 1.0)) exit(1);
  for (i = 0; i < 3 * kMany; ++i)
    points[i] = (float)((random = random * 1664525u + 1013904223u) >> 8);
  many = cloud_of(points, kMany);
  few = cloud_of(pair.source, pair.count);
  CHECK_OK(emtr_problem_create(&few, &few, NULL, &problem));

  emtr_set_interrupt(ask, &self);
  CHECK_ERROR(emtr_preprocess(&many, NULL, 2, &preprocessed), EMTR_ERROR_INTERRUPTED,
              "interrupted");
  CHECK(preprocessed == NULL && self.asked == 1);
  CHECK_ERROR(emtr_residuals(&many, &many, NULL, 2, out, NULL), EMTR_ERROR_INTERRUPTED,
              "interrupted");
  CHECK_ERROR(emtr_task_alpha_evaluate(problem, EMTR_RESOLUTION_DENSE, numbers, kParticles, out),
              EMTR_ERROR_INTERRUPTED, "interrupted");
  CHECK(self.asked == 3);
  emtr_set_interrupt(NULL, NULL);
  CHECK_OK(emtr_preprocess(&many, NULL, 2, &preprocessed));
  CHECK(self.asked == 3);

  emtr_preprocessed_free(preprocessed);
  emtr_problem_free(problem);
  bumpy_pair_free(&pair);
  free(out);
  free(numbers);
  free(points);
}

static void registrations_and_problems(void) {
  caller self = {0, 1, NULL};
  bumpy_pair pair;
  emtr_cloud source, target;
  emtr_problem* problem = NULL;
  emtr_result *alone = NULL, *result = NULL;
  if (bumpy_pair_make(&pair, 2, 4000, 1.0)) exit(1);
  source = cloud_of(pair.source, pair.count);
  target = cloud_of(pair.target, pair.count);
  CHECK_OK(emtr_register(&source, &target, NULL, NULL, NULL, &alone));

  emtr_set_interrupt(ask, &self);
  CHECK_ERROR(emtr_problem_create(&source, &target, NULL, &problem), EMTR_ERROR_INTERRUPTED,
              "interrupted");
  CHECK(problem == NULL && self.asked == 1);
  CHECK_OK(emtr_register(&source, &target, NULL, NULL, NULL, &result));
  CHECK(result && result->reason == EMTR_REASON_INTERRUPTED && self.asked == 2);
  emtr_result_free(result);

  /* a progress function takes the place of the interrupt function */
  CHECK_OK(emtr_register(&source, &target, NULL, go_on, NULL, &result));
  CHECK(result && result->registered && self.asked == 2);
  emtr_result_free(result);

  /* calls from within the function are not interrupted, and the run has the same bits */
  self.end = 0;
  self.cloud = &source;
  CHECK_OK(emtr_register(&source, &target, NULL, NULL, NULL, &result));
  CHECK(result && alone && self.asked > 2);
  if (result && alone)
    CHECK(memcmp(result->transformation, alone->transformation, sizeof alone->transformation) == 0);
  emtr_set_interrupt(NULL, NULL);
  emtr_result_free(result);
  emtr_result_free(alone);
  bumpy_pair_free(&pair);
}

int main(void) {
  CHECK(strcmp(emtr_status_text(EMTR_ERROR_INTERRUPTED), "interrupted") == 0);
  long_calls_end();
  registrations_and_problems();
  return check_result();
}
