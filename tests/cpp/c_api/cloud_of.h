/* Makes a cloud of packed x, y, z in single precision. */
#ifndef EMTR_TESTS_CLOUD_OF_H
#define EMTR_TESTS_CLOUD_OF_H

#include <emtr/emtr.h>

static inline emtr_cloud cloud_of(const float* points, size_t count) {
  emtr_cloud cloud = {.points = points, .count = count, .scalar = EMTR_FLOAT32};
  return cloud;
}

#endif /* EMTR_TESTS_CLOUD_OF_H */
