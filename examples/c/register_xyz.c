/* Registers two clouds that are text, one point "x y z" a line: register_xyz SOURCE TARGET.
 * Prints the transformation, source into target, and the verdict. Returns 0 if registered, 3 if
 * not, and 2 on an error. */
#include <emtr/emtr.h>
#include <stdio.h>
#include <stdlib.h>

typedef struct points {
  double* xyz; /* x, y, z of one point after the other */
  size_t count;
} points;

static int read_points(const char* path, points* cloud) {
  size_t room = 0;
  double p[3];
  int numbers;
  FILE* file = fopen(path, "r");
  cloud->xyz = NULL;
  cloud->count = 0;
  if (file == NULL) {
    fprintf(stderr, "%s: cannot be opened\n", path);
    return 0;
  }
  while ((numbers = fscanf(file, "%lf %lf %lf", &p[0], &p[1], &p[2])) == 3) {
    if (cloud->count == room) {
      double* larger = realloc(cloud->xyz, (room = 2 * room + 1024) * 3 * sizeof(double));
      if (larger == NULL) break;
      cloud->xyz = larger;
    }
    for (int i = 0; i < 3; ++i) cloud->xyz[3 * cloud->count + i] = p[i];
    ++cloud->count;
  }
  fclose(file);
  if (numbers == EOF) return 1;
  fprintf(stderr, "%s: point %lu: expected three numbers, and memory for them\n", path,
          (unsigned long)cloud->count + 1);
  return 0;
}

static int register_points(const points* source, const points* target) {
  emtr_cloud from = {.points = source->xyz, .count = source->count, .scalar = EMTR_FLOAT64};
  emtr_cloud to = {.points = target->xyz, .count = target->count, .scalar = EMTR_FLOAT64};
  emtr_settings settings;
  emtr_result* result = NULL;
  int registered;
  if (emtr_settings_init(&settings, sizeof settings, "default") != EMTR_OK ||
      emtr_register(&from, &to, &settings, NULL, NULL, &result) != EMTR_OK) {
    fprintf(stderr, "%s\n", emtr_error_message());
    return 2;
  }
  for (int i = 0; i < 16; ++i) printf("%.9g%c", result->transformation[i], i % 4 == 3 ? '\n' : ' ');
  fprintf(stderr, "%s, confidence %.3f\n", emtr_reason_text(result->reason), result->confidence);
  registered = result->registered;
  emtr_result_free(result);
  return registered ? 0 : 3;
}

int main(int argc, char** argv) {
  points source = {NULL, 0}, target = {NULL, 0};
  int status = 2;
  if (argc != 3)
    fprintf(stderr, "usage: register_xyz SOURCE TARGET\n");
  else if (read_points(argv[1], &source) && read_points(argv[2], &target))
    status = register_points(&source, &target);
  free(source.xyz);
  free(target.xyz);
  return status;
}
