/* What a module gives to the command: a plain C interface, so that a module may be built by itself.
 */
#ifndef EMTR_MODULE_H
#define EMTR_MODULE_H

#include <stddef.h>
#include <stdint.h>

#define EMTR_MODULE_VERSION 1

/* Where a module puts what it reads. Each function returns 0, or non-zero when the module has to
   stop: memory has run out. */
typedef struct emtr_module_sink {
  /* Is called once, before the points: the fields after x, y and z, and how many points come. */
  int (*begin)(struct emtr_module_sink* sink, const char* const* names, size_t fields,
               uint64_t points);
  /* Adds a point: x, y, z and the fields. */
  int (*add)(struct emtr_module_sink* sink, const double* values);
  /* Tells something that was left out; may be called any number of times. */
  void (*note)(struct emtr_module_sink* sink, const char* text);
} emtr_module_sink;

/* Reads the file at `place`. Returns 0, or writes what is wrong with the file to `error`, a text of
   at most `size` bytes. Every module has this function under this name. */
typedef int emtr_module_read(const char* place, emtr_module_sink* sink, char* error, size_t size);

#endif
