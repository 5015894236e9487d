/* Two scans of one bumpy ball from different sides, made here, so that the pose is known exactly:
 * points drawn independently, each with its own noise. For C99 and C++. */
#ifndef EMTR_TESTS_BUMPY_PAIR_H
#define EMTR_TESTS_BUMPY_PAIR_H

#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

typedef struct bumpy_pair {
  size_t count;  /* points of each scan */
  double unit;   /* radius of the ball in the user's unit */
  float* source; /* x, y, z packed, to be freed by bumpy_pair_free() */
  float* target;
  double pose[16]; /* source into target, row-major, user's unit */
} bumpy_pair;

enum { BUMPY_BUMPS = 18 };

/* splitmix64: the same numbers with every compiler and standard library */
static inline double bumpy_uniform(uint64_t* state) {
  uint64_t z = (*state += UINT64_C(0x9e3779b97f4a7c15));
  z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
  z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
  return (double)((z ^ (z >> 31)) >> 11) / 9007199254740992.0;
}

static inline double bumpy_gaussian(uint64_t* state) {
  const double radius = sqrt(-2.0 * log(1.0 - bumpy_uniform(state)));
  return radius * cos(6.283185307179586 * bumpy_uniform(state));
}

static inline void bumpy_direction(uint64_t* state, double u[3]) {
  double norm = 0.0;
  int i;
  for (i = 0; i < 3; ++i) u[i] = bumpy_gaussian(state);
  norm = sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
  for (i = 0; i < 3; ++i) u[i] /= norm;
}

static inline double bumpy_dot(const double a[3], const double b[3]) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* The part of the surface that faces `view`, in the frame of the ball with radius 1. */
static inline void bumpy_scan(const double (*bump)[5], const double view[3], uint64_t* state,
                              size_t count, double* points) {
  size_t made = 0;
  while (made < count) {
    double u[3], radius = 1.0;
    int i;
    bumpy_direction(state, u);
    if (bumpy_dot(u, view) < -0.1) continue;
    for (i = 0; i < BUMPY_BUMPS; ++i)
      radius += bump[i][3] * exp(bump[i][4] * (bumpy_dot(u, bump[i]) - 1.0));
    for (i = 0; i < 3; ++i)
      points[3 * made + (size_t)i] = radius * u[i] + 0.002 * bumpy_gaussian(state);
    ++made;
  }
}

static inline void bumpy_random_pose(uint64_t* state, double unit, double pose[16]) {
  double q[4], norm = 0.0;
  int i;
  for (i = 0; i < 4; ++i) q[i] = bumpy_gaussian(state);
  for (i = 0; i < 4; ++i) norm += q[i] * q[i];
  for (i = 0; i < 4; ++i) q[i] /= sqrt(norm);
  {
    const double w = q[0], x = q[1], y = q[2], z = q[3];
    const double r[9] = {1 - 2 * (y * y + z * z), 2 * (x * y - w * z),     2 * (x * z + w * y),
                         2 * (x * y + w * z),     1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
                         2 * (x * z - w * y),     2 * (y * z + w * x),     1 - 2 * (x * x + y * y)};
    for (i = 0; i < 3; ++i) {
      pose[4 * i] = r[3 * i];
      pose[4 * i + 1] = r[3 * i + 1];
      pose[4 * i + 2] = r[3 * i + 2];
      pose[4 * i + 3] = unit * (4.0 * bumpy_uniform(state) - 2.0);
      pose[12 + i] = 0.0;
    }
    pose[15] = 1.0;
  }
}

/* Returns 0, or 1 when memory has run out. */
static inline int bumpy_pair_make(bumpy_pair* pair, uint64_t seed, size_t count, double unit) {
  double bump[BUMPY_BUMPS][5]; /* direction, height, sharpness */
  double view_source[3] = {0.35, 0.0, 0.94}, view_target[3] = {-0.35, 0.0, 0.94};
  double* ball = (double*)malloc(6 * count * sizeof(double));
  uint64_t state = seed;
  size_t i;
  int k;
  pair->count = count;
  pair->unit = unit;
  pair->source = (float*)malloc(3 * count * sizeof(float));
  pair->target = (float*)malloc(3 * count * sizeof(float));
  if (!ball || !pair->source || !pair->target) return 1;

  for (k = 0; k < BUMPY_BUMPS; ++k) {
    bumpy_direction(&state, bump[k]);
    bump[k][3] = (bumpy_uniform(&state) < 0.5 ? -1 : 1) * (0.1 + 0.2 * bumpy_uniform(&state));
    bump[k][4] = 6.0 + 24.0 * bumpy_uniform(&state);
  }
  bumpy_scan((const double(*)[5])bump, view_source, &state, count, ball);
  bumpy_scan((const double(*)[5])bump, view_target, &state, count, ball + 3 * count);
  bumpy_random_pose(&state, unit, pair->pose);
  for (i = 0; i < count; ++i) {
    double p[3];
    for (k = 0; k < 3; ++k) {
      p[k] = unit * ball[3 * i + (size_t)k] - pair->pose[4 * k + 3];
      pair->target[3 * i + (size_t)k] = (float)(unit * ball[3 * (count + i) + (size_t)k]);
    }
    for (k = 0; k < 3; ++k)
      pair->source[3 * i + (size_t)k] =
          (float)(pair->pose[k] * p[0] + pair->pose[4 + k] * p[1] + pair->pose[8 + k] * p[2]);
  }
  free(ball);
  return 0;
}

static inline void bumpy_pair_free(bumpy_pair* pair) {
  free(pair->source);
  free(pair->target);
  pair->source = pair->target = NULL;
}

/* How far an estimated pose (row-major, source into target) puts the source points from where
 * they belong: root mean square in radii of the ball; 5 degrees are about 0.07. NaN for NaN. */
static inline double bumpy_pair_error(const bumpy_pair* pair, const double estimate[16]) {
  double sum = 0.0;
  size_t i;
  int k;
  for (i = 0; i < pair->count; ++i) {
    const float* p = pair->source + 3 * i;
    for (k = 0; k < 3; ++k) {
      const double* a = estimate + 4 * k;
      const double* b = pair->pose + 4 * k;
      const double d =
          (a[0] - b[0]) * p[0] + (a[1] - b[1]) * p[1] + (a[2] - b[2]) * p[2] + (a[3] - b[3]);
      sum += d * d;
    }
  }
  return sqrt(sum / (double)pair->count) / pair->unit;
}

#endif /* EMTR_TESTS_BUMPY_PAIR_H */
