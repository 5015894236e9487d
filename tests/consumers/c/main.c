/* Registers a synthetic pair; prints the true and the found transformation. */
#include <emtr/emtr.h>
#include <stdio.h>

#include "bumpy_pair.h"

static void print(const double matrix[16]) {
  int i;
  for (i = 0; i < 16; ++i) printf("%.17g%c", matrix[i], i == 15 ? '\n' : ' ');
}

int main(void) {
  bumpy_pair pair;
  emtr_cloud source = {.scalar = EMTR_FLOAT32}, target = {.scalar = EMTR_FLOAT32};
  emtr_result* result = NULL;
  if (bumpy_pair_make(&pair, 4, 3000, 1.0)) return 1;
  source.points = pair.source;
  target.points = pair.target;
  source.count = target.count = pair.count;
  if (emtr_register(&source, &target, NULL, NULL, NULL, &result) != EMTR_OK) {
    fprintf(stderr, "%s\n", emtr_error_message());
    return 1;
  }
  print(pair.pose);
  print(result->transformation);
  emtr_result_free(result);
  bumpy_pair_free(&pair);
  return 0;
}
