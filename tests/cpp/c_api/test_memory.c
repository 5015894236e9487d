/* Tests that too little address space gives EMTR_ERROR_MEMORY, and that later calls work again. */
#define _XOPEN_SOURCE 600
#include <stdlib.h>
#include <sys/resource.h>

#include "bumpy_pair.h"
#include "check.h"
#include "cloud_of.h"

static bumpy_pair pair;

static rlim_t used(void) {
  unsigned long pages = 0;
  FILE* file = fopen("/proc/self/statm", "r");
  if (!file || fscanf(file, "%lu", &pages) != 1) exit(77); /* not Linux: skipped */
  fclose(file);
  return (rlim_t)pages * 4096;
}

static void limit(rlim_t most) {
  struct rlimit value;
  CHECK(getrlimit(RLIMIT_AS, &value) == 0);
  value.rlim_cur = most;
  CHECK(setrlimit(RLIMIT_AS, &value) == 0);
}

static void require_limits(void) {
  void* volatile much; /* else the compiler may leave out both calls */
  limit(used() + ((rlim_t)1 << 20));
  much = malloc((size_t)256 << 20);
  limit(RLIM_INFINITY);
  if (!much) return;
  free(much);
  exit(77); /* an emulator that gives more than the limit: skipped */
}

static void under_limits(const char* preset, int threads) {
  const emtr_cloud source = cloud_of(pair.source, pair.count);
  const emtr_cloud target = cloud_of(pair.target, pair.count);
  const rlim_t before = used();
  emtr_settings settings;
  emtr_result* result = NULL;
  emtr_preprocessed* preprocessed = NULL;
  emtr_problem* problem = NULL;
  int kilobytes, refused = 0;
  CHECK_OK(emtr_settings_init(&settings, sizeof settings, preset));
  settings.threads = threads;
  for (kilobytes = 0; kilobytes <= 256 * 1024; kilobytes = kilobytes * 3 / 2 + 500) {
    emtr_status status;
    limit(before + (rlim_t)kilobytes * 1024);
    status = emtr_register(&source, &target, &settings, NULL, NULL, &result);
    CHECK(status == EMTR_OK || status == EMTR_ERROR_MEMORY);
    CHECK((status == EMTR_OK) == (result != NULL));
    if (status == EMTR_ERROR_MEMORY) CHECK(strstr(emtr_error_message(), "memory") != NULL);
    refused += status == EMTR_ERROR_MEMORY;
    emtr_result_free(result);
    status = emtr_problem_create(&source, &target, &settings, &problem);
    CHECK(status == EMTR_OK || status == EMTR_ERROR_MEMORY);
    emtr_problem_free(problem);
    status = emtr_preprocess(&source, "a", threads, &preprocessed);
    CHECK(status == EMTR_OK || status == EMTR_ERROR_MEMORY);
    emtr_preprocessed_free(preprocessed);
  }
  CHECK(refused > 0);
  limit(RLIM_INFINITY);
  CHECK_OK(emtr_register(&source, &target, &settings, NULL, NULL, &result));
  if (result) CHECK(bumpy_pair_error(&pair, result->transformation) < 0.1);
  emtr_result_free(result);
}

int main(int argc, char** argv) {
  if (argc != 3) return 1;
  require_limits();
  if (bumpy_pair_make(&pair, 1, 3000, 1.0)) return 1;
  under_limits(argv[1], atoi(argv[2]));
  bumpy_pair_free(&pair);
  return check_result();
}
