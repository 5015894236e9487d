/* Counts and reports checks that fail, and goes on. */
#ifndef EMTR_TESTS_CHECK_H
#define EMTR_TESTS_CHECK_H

#include <emtr/emtr.h>
#include <stdio.h>
#include <string.h>

static int check_failures = 0;

#define CHECK(condition)                                                             \
  do {                                                                               \
    if (!(condition)) {                                                              \
      ++check_failures;                                                              \
      fprintf(stderr, "%s:%d: does not hold: %s\n", __FILE__, __LINE__, #condition); \
    }                                                                                \
  } while (0)

/* Checks that the call succeeds; shows the library's message if it does not. */
#define CHECK_OK(call)                                                  \
  do {                                                                  \
    const emtr_status check_status = (call);                            \
    if (check_status != EMTR_OK) {                                      \
      ++check_failures;                                                 \
      fprintf(stderr, "%s:%d: %s: %s: %s\n", __FILE__, __LINE__, #call, \
              emtr_status_text(check_status), emtr_error_message());    \
    }                                                                   \
  } while (0)

/* Checks that the call fails with this status and a message that contains `word`. */
#define CHECK_ERROR(call, expected, word)                                                          \
  do {                                                                                             \
    const emtr_status check_status = (call);                                                       \
    if (check_status != (expected) || !strstr(emtr_error_message(), (word))) {                     \
      ++check_failures;                                                                            \
      fprintf(stderr, "%s:%d: %s: expected \"%s\" about \"%s\", got \"%s\": %s\n", __FILE__,       \
              __LINE__, #call, emtr_status_text(expected), (word), emtr_status_text(check_status), \
              emtr_error_message());                                                               \
    }                                                                                              \
  } while (0)

static inline int check_result(void) {
  if (check_failures) fprintf(stderr, "%d checks failed\n", check_failures);
  return check_failures ? 1 : 0;
}

#endif /* EMTR_TESTS_CHECK_H */
