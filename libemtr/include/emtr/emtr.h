/* emtr: global registration of two partially overlapping point clouds by EMTR-SSC.
 *
 * The C API, and the one ABI that is promised. Plain structs and pointers, C99.
 *
 * Direction: every transformation maps SOURCE into TARGET, q = R p + t, as a 4x4 row-major
 * array of double in the user's own unit.
 * Method: Wu et al., "Evolutionary Multitasking with Solution Space Cutting for Point Cloud
 * Registration", IEEE Transactions on Emerging Topics in Computational Intelligence, 2023.
 * Threads: all functions may be called from many threads at once, on separate objects.
 * The library writes nothing to standard output or standard error. */
#ifndef EMTR_EMTR_H
#define EMTR_EMTR_H

#include <stddef.h>
#include <stdint.h>

#define EMTR_VERSION_MAJOR 0
#define EMTR_VERSION_MINOR 2
#define EMTR_VERSION_PATCH 0

#if defined(_WIN32)
#define EMTR_API
#else
#define EMTR_API __attribute__((visibility("default")))
#endif

/* Fields that an initialiser may leave out: in C they are zero by themselves. */
#if defined(__cplusplus) && __cplusplus >= 201402L
#define EMTR_ZERO \
  {}
#else
#define EMTR_ZERO
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* ---- errors ------------------------------------------------------------------------- */

typedef enum emtr_status {
  EMTR_OK = 0,
  EMTR_ERROR_ARGUMENT = 1, /* a null pointer, a wrong size field, a bad stride or type */
  EMTR_ERROR_SETTING = 2,  /* an unknown setting, a value out of range, a contradiction */
  EMTR_ERROR_CLOUD = 3,    /* a cloud that cannot be registered: too few points, no extent */
  /* an allocation failed, on whatever thread */
  EMTR_ERROR_MEMORY = 4,
  EMTR_ERROR_INTERNAL = 5,   /* a defect of the library or of what it is built on */
  EMTR_ERROR_INTERRUPTED = 6 /* what emtr_set_interrupt() was given asked for the end */
} emtr_status;

/* What a status means in general, in a few words. Never null. */
EMTR_API const char* emtr_status_text(emtr_status status);

/* What went wrong in the last failed call of this thread: names the cloud, the argument or
 * the setting and what was expected. Never null; empty when nothing has failed. */
EMTR_API const char* emtr_error_message(void);

/* Returns other than 0 to end the call that asks. May call the library; such calls ask nobody. */
typedef int (*emtr_interrupt_fn)(void* user);

/* Whom the further calls of this thread ask, every 20 ms or so, whether to end: those that take no
 * progress function or are given none. A registration ends as interrupted, any other call with
 * EMTR_ERROR_INTERRUPTED. Null: nobody, as at first. */
EMTR_API void emtr_set_interrupt(emtr_interrupt_fn interrupt, void* user);

/* The library's version, as "major.minor.patch". */
EMTR_API const char* emtr_version(void);

/* The instruction set of the inner loops: "generic", "avx2" or "avx512", the fastest that the
 * machine has, or what the variable EMTR_KERNEL asks for; the result has the same bits with each.
 * Null, with a message, when EMTR_KERNEL asks for what this machine cannot run; a registration
 * is then an EMTR_ERROR_SETTING. */
EMTR_API const char* emtr_kernel_name(void);

/* ---- settings ----------------------------------------------------------------------- */

/* Each field has the name that the shell and Python use. But for what is known beforehand, at
 * the end, lengths are never in the user's unit: they are multiples of a leaf, of the
 * resolution, or of the normalized frame, in which both clouds are centred and the larger one
 * has radius 1.
 * emtr_setting_describe() gives unit, range, default and meaning of each. */
typedef struct emtr_settings {
  size_t size;       /* sizeof(emtr_settings), set by emtr_settings_init() */
  uint64_t seed;     /* any; the same seed gives the same bits */
  int32_t threads;   /* 0: as many as OpenMP would use; the result does not depend on it */
  double time_limit; /* seconds, 0: none. A run that takes longer gives its best pose so far */

  /* densities */
  int32_t dense_points;        /* both dense clouds together */
  int32_t sparse_points;       /* the sparse source cloud */
  double minimum_leaf_spacing; /* dense leaf >= this many point spacings */

  /* features and matches */
  double normal_radius;        /* dense leaves */
  double feature_radius;       /* dense leaves */
  int32_t features;            /* 0 PCL's own functions, 1 vectorised: the same definition */
  int32_t max_correspondences; /* matches kept, those with the nearest descriptors */
  int32_t max_tims;            /* cap on pairs of correspondences */

  /* seeds: poses that spatially consistent matches agree on */
  int32_t seeds;          /* 0: none */
  double seed_threshold;  /* dense leaves */
  int32_t injected_seeds; /* of them, particles of both swarms that start there */

  /* task beta */
  double tau_factor;       /* tau / mean resolution of the dense clouds */
  double inlier_threshold; /* in tau */
  double outlier_penalty;  /* eta, in tau */

  /* task alpha */
  double scale_sparse;      /* c of the S stage, sparse leaves */
  double scale_dense;       /* c of the D stage, dense leaves */
  double translation_bound; /* half the side of the box, normalized frame */

  /* swarm */
  int32_t population; /* particles of each task */
  int32_t iterations; /* MaxIt */
  double inertia_start;
  double inertia_end;
  double cognitive;      /* c1 */
  double social;         /* c2 */
  double velocity_limit; /* share of each gene's range */
  /* rotations of both swarms step by rotation vectors, in the tangent space of SO(3), instead of
   * by Euler angles: 0 off, 1 where no particle starts at a seed, 2 always. Where a prior limits
   * the rotation the genes are made for that, and step as they are */
  int32_t rotation_vector_steps;

  /* knowledge transfer and complement (Algorithm 2) */
  int32_t transfer;            /* 0: the tasks do not talk (ablation) */
  double transfer_probability; /* rmp */
  /* the rotation of a guide lies on the shortest arc between the two bests, instead of between
   * their angles: 0 off, 1 where no particle starts at a seed, 2 always */
  int32_t arc_transfer;
  double lambda_alpha_start;
  double lambda_alpha_end;
  double lambda_beta_start;
  double lambda_beta_end;
  int32_t complement;            /* 0: alpha keeps its own translation (ablation) */
  int32_t complement_iterations; /* MaxIt_KC */
  double complement_scale_start; /* d, normalized frame */
  double complement_scale_end;

  /* sparse to dense */
  int32_t sparse_to_dense; /* 0: the D stage throughout (ablation) */
  double switch_fraction;  /* delta */

  /* nearest neighbors of the fitness: 0 grid, 1 pcl kd-tree, 2 brute force; same bits */
  int32_t neighbors;

  /* candidates: seeds and modes of the swarm, polished and ranked on the surfaces */
  int32_t candidates; /* 0: the swarm's best is the answer */
  int32_t free_space; /* 0: points in front of what the other scan saw cost nothing */

  /* fallback search: more feature points, both signs of the normals, more candidates */
  int32_t fallback_search; /* 0 off, 1 when the confidence is below fallback_confidence, 2 always */
  double fallback_confidence;
  int32_t fallback_points; /* of both clouds together */
  int32_t fallback_correspondences;
  int32_t fallback_seeds;
  int32_t fallback_candidates;

  /* refinement of the answer on fine clouds */
  int32_t refine;     /* 0: off */
  double refine_leaf; /* normalized frame */

  /* verdict */
  double maximum_fitness;
  double minimum_fitness_gap;
  double minimum_confidence;

  /* a pose to try as one hypothesis among the particles (not a starting point that the
   * search stays near, unless guess_rotation or guess_translation say so); row-major, source into
   * target, the user's unit. Where a prior does not admit it, the nearest pose that it admits */
  int32_t has_guess;
  double guess[16];

  /* where each cloud's sensor stood, in that cloud's own frame and unit: unknown when the switch
   * is 0, and then estimated where it is needed */
  int32_t has_viewpoint_source;
  double viewpoint_source[3];
  int32_t has_viewpoint_target;
  double viewpoint_target[3];

  /* priors: what is known of the pose. All that are given hold at once, for every pose that is
   * looked at, and up to rounding for the transformation and the alternatives of the result. A
   * set of priors that admits no pose is an EMTR_ERROR_SETTING that names them. Lengths here are
   * in the user's unit. */
  double guess_rotation;    /* degrees that the rotation may be from the guess's; 180: any */
  double guess_translation; /* user's unit: how far the source's centroid may end from where the
                               guess puts it; 1e12: anywhere */
  int32_t has_axis;         /* 1: only rotations about the axis */
  double axis[3];           /* its direction, the same in both clouds' frames, of any length > 0:
                               up, say, for scanners that know where down is */
  double axis_tilt;         /* degrees that the rotated axis may lean from itself */
  /* degrees about the axis by the right hand; -180 to 180: any. Of a rotation that tilts the axis
   * too, of the turn before the tilt */
  double axis_angle_minimum;
  double axis_angle_maximum;
  int32_t has_translation_bounds;
  /* of the translation in the result's matrix, user's unit: where the origin ends; finite */
  double translation_minimum[3];
  double translation_maximum[3];
  double maximum_rotation; /* degrees of the whole rotation; 180: any */

  /* matches made elsewhere, in the place of our own: pairs (row of the source's points, row of the
   * target's), correspondence_count of them; null: none. At least 3 different ones, of finite
   * points; of more than max_correspondences so many are taken, evenly spread over the list */
  const int32_t* correspondences;
  size_t correspondence_count;
} emtr_settings;

/* Values of the settings that are a choice. */
typedef enum emtr_when {
  EMTR_OFF = 0,  /* never */
  EMTR_AUTO = 1, /* where the setting says that it helps */
  EMTR_ALWAYS = 2
} emtr_when; /* fallback_search, rotation_vector_steps, arc_transfer */

typedef enum emtr_features { EMTR_FEATURES_PCL = 0, EMTR_FEATURES_SIMD = 1 } emtr_features;

typedef enum emtr_neighbors {
  EMTR_NEIGHBORS_GRID = 0,
  EMTR_NEIGHBORS_KDTREE = 1,
  EMTR_NEIGHBORS_BRUTE_FORCE = 2
} emtr_neighbors;

/* Fills *settings with a preset: "default" (also for a null pointer), "fast", "thorough" or
 * "paper", which is the method as published. `size` is
 * sizeof(emtr_settings) as the caller was compiled. */
EMTR_API emtr_status emtr_settings_init(emtr_settings* settings, size_t size, const char* preset);

/* The presets by index, null past the last. */
EMTR_API const char* emtr_preset_name(size_t index);

typedef enum emtr_setting_type {
  EMTR_SETTING_INTEGER = 0,
  EMTR_SETTING_REAL = 1,
  EMTR_SETTING_SWITCH = 2, /* 0 or 1 */
  EMTR_SETTING_CHOICE = 3  /* an integer that stands for one of `choices` */
} emtr_setting_type;

typedef struct emtr_setting_info {
  const char* name;
  emtr_setting_type type;
  const char* unit;    /* "" where it has none */
  double minimum;      /* inclusive */
  double maximum;      /* inclusive */
  double value;        /* in preset "default" */
  const char* part;    /* the part of the method that it belongs to, "" for none */
  const char* text;    /* one line */
  const char* choices; /* of a CHOICE: names by value, comma separated; else "" */
} emtr_setting_info;

/* The settings that have a name (all but size, the vectors with their has_... and correspondences),
 * in a fixed order. Here and below `size` is sizeof of the info as the caller was compiled: later
 * versions append fields, and what this version does not know is set to zero. Less than this
 * version's is an error. */
EMTR_API size_t emtr_setting_count(void);
EMTR_API emtr_status emtr_setting_describe(size_t index, emtr_setting_info* info, size_t size);

/* Sets or reads a setting by name. The range is checked here, contradictions between
 * settings when they are used. A seed above 2^53 must be set in the struct. */
EMTR_API emtr_status emtr_setting_set(emtr_settings* settings, const char* name, double value);
EMTR_API emtr_status emtr_setting_get(const emtr_settings* settings, const char* name,
                                      double* value);

/* ---- input -------------------------------------------------------------------------- */

typedef enum emtr_scalar { EMTR_FLOAT32 = 0, EMTR_FLOAT64 = 1 } emtr_scalar;

/* x, y, z side by side in memory; `stride` bytes from one point to the next (0: packed).
 * No alignment is asked for. Points with a NaN or an infinity are dropped and counted.
 * Needed: at least 10 finite points, 10 also after thinning (some 25 well spread ones do), that
 * do not lie on one point or one line.
 *
 * What was computed elsewhere can be handed in, one row a point; null: none (initialise it all).
 * Normals replace those that would be estimated. They need not be of unit length; a point whose
 * normal has a NaN, an infinity or no length has none. Where both clouds have some, the side that
 * they point to counts in the features.
 * Features are descriptors of any kind, both clouds or none, compared by Euclidean distance: the
 * mutual nearest ones are matched, as those of our own would be. A point whose row has a NaN or an
 * infinity has none. Of a cloud with more than 20 000 described points one in each dense leaf is
 * matched, the nearest to its middle. */
typedef struct emtr_cloud {
  const void* points;
  size_t count;
  size_t stride;
  emtr_scalar scalar;
  const void* normals EMTR_ZERO;      /* x, y, z, of the scalar of the points */
  size_t normal_stride EMTR_ZERO;     /* bytes from one to the next, 0: packed */
  const float* features EMTR_ZERO;    /* row-major (count, feature_dimension) */
  size_t feature_dimension EMTR_ZERO; /* 1 to 65536 */
  size_t feature_stride EMTR_ZERO;    /* bytes from one row to the next, 0: packed */
  /* 1: to be registered with correspondences once it is prepared. All points are kept then, also of
   * a cloud of more than 200 000, at 12 bytes each; smaller clouds always keep them */
  int32_t keep_points EMTR_ZERO;
} emtr_cloud;

/* ---- progress ----------------------------------------------------------------------- */

typedef struct emtr_progress {
  const char* stage;  /* one of emtr_stage_name() */
  int32_t iteration;  /* done, in "evolution"; else 0 */
  int32_t iterations; /* in all */
  double best_alpha;  /* fitness of gbest of task alpha, lower is better */
  double best_beta;
} emtr_progress;

/* Returns the name of a stage, in the order in which they run: "normalization", "downsampling",
 * "features", "matching", "seeds", "evolution", "candidates", "fallback_search", "refinement",
 * "verdict". Null past the last. */
EMTR_API const char* emtr_stage_name(size_t index);

/* Called on the calling thread: before each stage, after each iteration, and again with the same
 * progress about every 20 ms while a stage lasts, however long. Non-zero stops the run within 100
 * ms: the result then has reason EMTR_REASON_INTERRUPTED and the best pose so far. It may call the
 * library, but for functions of the problem that is being solved. What it throws in C++ ends the
 * run with EMTR_ERROR_INTERNAL. It sees the default floating-point environment. */
typedef int (*emtr_progress_fn)(const emtr_progress* progress, void* user);

/* ---- result ------------------------------------------------------------------------- */

typedef enum emtr_reason {
  EMTR_REASON_REGISTERED = 0,
  EMTR_REASON_LOW_OVERLAP = 1, /* too few points of the clouds lie on each other */
  EMTR_REASON_AMBIGUOUS = 2,   /* another, clearly different pose fits about as well */
  EMTR_REASON_FEW_MATCHES = 3, /* too few feature matches for task beta to mean anything */
  EMTR_REASON_INTERRUPTED = 4, /* stopped by the progress callback */
  EMTR_REASON_DEGENERATE = 5,  /* the surfaces can slide or spin along themselves */
  EMTR_REASON_TIME_LIMIT = 6   /* stopped by the setting time_limit */
} emtr_reason;

/* A reason's short name, which stays the same: "registered", "low_overlap", "ambiguous",
 * "few_matches", "interrupted", "degenerate", "time_limit". "unknown" for what is none. */
EMTR_API const char* emtr_reason_name(emtr_reason reason);

/* What a reason means, in a few words. Never null. */
EMTR_API const char* emtr_reason_text(emtr_reason reason);

/* Another pose that the clouds could be in. */
typedef struct emtr_alternative {
  double transformation[16]; /* as in the result */
  double score;              /* as in the result, never more than the answer's */
} emtr_alternative;

/* Owned by the library, freed by emtr_result_free(). Later versions append fields. */
typedef struct emtr_result {
  size_t size; /* of this struct, as the library was compiled */

  double transformation[16]; /* source into target, row-major, user's unit; orthonormal R.
                                When stopped (reasons INTERRUPTED and TIME_LIMIT) the best pose
                                so far, all NaN when none was known yet */
  int32_t registered;        /* 1: the pose is held to be right; 0: doubtful */
  emtr_reason reason;

  /* quality, at the dense clouds */
  double fitness;             /* mean of rho over both dense clouds, 0 (best) to 1 */
  double inlier_ratio_source; /* share of dense source points within c of the target */
  double inlier_ratio_target;
  double fitness_gap; /* fitness of the best clearly different pose (over 10 degrees
                      or 0.15 radii away) minus that of this one */

  /* quality, at the fine clouds: both thinned by `leaf_fine`. Up to 5000 points of each cloud, as
   * they were given (of a large one after its first thinning), evenly over their order, are asked
   * for a partner: the nearest fine point of the other cloud, not more than leaf_fine away. NaN
   * when interrupted */
  double overlap_source; /* share of the source's points that have a partner */
  double overlap_target;
  double inlier_rmse;       /* root mean square over the source's points that have one, of the
                               distance to it (point to point), user's unit; NaN when none has */
  double inlier_rmse_plane; /* the same of the distance to the partner's tangent plane, which does
                               not grow with the spacing of the points */

  /* counts */
  size_t points_source; /* finite */
  size_t points_target;
  size_t dropped_source; /* with NaN or infinity */
  size_t dropped_target;
  size_t sparse_source;
  size_t sparse_target;
  size_t dense_source;
  size_t dense_target;
  size_t correspondences;
  size_t tims;        /* formed, max_tims at most, of which */
  size_t tims_pruned; /* can be no inlier of any rotation and need no work */

  /* nearest neighbor look-ups, the paper's cost */
  uint64_t queries_evaluation; /* of the particles */
  uint64_t queries_switch;     /* of the pbests, evaluated again at the switch */
  uint64_t queries_complement; /* of Algorithm 2 */

  /* the normalized frame: p' = (p - center) / normalization_scale */
  double normalization_scale; /* user's unit */
  double center_source[3];
  double center_target[3];
  double leaf_sparse; /* normalized frame */
  double leaf_dense;
  double leaf_fine; /* NaN when interrupted */

  /* wall seconds */
  double seconds_normalization;
  double seconds_downsampling;
  double seconds_features;
  double seconds_matching;
  double seconds_evolution;
  double seconds_verdict;
  double seconds_total;

  /* best fitness so far of both tasks, after each iteration done; alpha's scale changes at
   * the switch */
  size_t iterations; /* done */
  const double* history_alpha;
  const double* history_beta;

  uint64_t seed;
  int32_t threads;    /* asked for; OpenMP may have given fewer */
  const char* kernel; /* what emtr_kernel_name() gave */

  /* the answer's standing among the candidates */
  double confidence; /* held probability that the pose is right (within 5 degrees and 0.06 radii),
                        0 to 1, in steps of 1e-6; NaN without candidates, as the four below, and
                        when stopped before all of them were ranked */
  double score;      /* fit - 2 violation, at most 1 */
  double surface_fit; /* how well the surfaces lie on each other, 0 to 1 (best) */
  double violation;  /* share of points in front of what the other scan saw */
  double score_gap;  /* score minus that of the best clearly different candidate */
  size_t seeds;      /* poses that consistent matches gave, at all feature densities */
  size_t candidates; /* distinct poses ranked */
  int32_t used_fallback_search; /* 1: searched again with more feature points */
  int32_t refined;   /* 1: polished on fine clouds */
  size_t alternative_count; /* clearly different poses, best first, at most 10 */
  const emtr_alternative* alternatives;

  /* of a refined pose: the inverse of its covariance for a small rotation w (radians) and shift v
   * (user's unit), order (w, v), row-major: q = exp(w) (R p + t - c) + c + v, c center_target.
   * NaN when it was not refined */
  double information[36];
  /* how firmly the matched surfaces hold the pose, ascending, 0 for a motion that slides them along
   * themselves to about 1: eigenvalues of the Hessian, rotations measured at the surfaces' radius.
   * NaN when it was not refined */
  double hessian_eigenvalues[6];
  double hessian_eigenvectors[36]; /* unit vectors, one a row: rotation at that radius, then shift */
  int32_t unconstrained_directions;    /* how many are not held; -1 when it was not refined */

  double seconds_seeds;
  double seconds_candidates;
  double seconds_fallback_search;
  double seconds_refinement;

  size_t correspondences_found; /* before max_correspondences of them were kept */
} emtr_result;

EMTR_API void emtr_result_free(emtr_result* result);

typedef enum emtr_field_type {
  EMTR_FIELD_REAL = 0,       /* double */
  EMTR_FIELD_INT32 = 1,      /* int32_t */
  EMTR_FIELD_SWITCH = 2,     /* int32_t, 0 or 1 */
  EMTR_FIELD_SIZE = 3,       /* size_t */
  EMTR_FIELD_UINT64 = 4,     /* uint64_t */
  EMTR_FIELD_TEXT = 5,       /* const char* */
  EMTR_FIELD_REASON = 6,     /* emtr_reason, named by emtr_reason_name() */
  EMTR_FIELD_ALTERNATIVE = 7 /* emtr_alternative */
} emtr_field_type;

/* Describes a field of emtr_result, so that a program can read all of them without knowing their
 * names. The values lie `offset` bytes from the beginning of the result, row by row. Where
 * `columns` is 0 a pointer lies there instead, to one row whose length is the size_t that lies
 * `count_offset` bytes from the beginning. */
typedef struct emtr_result_field_info {
  const char* name;  /* in emtr_result */
  const char* group; /* where a report puts it: "quality", "refinement", "counts", "queries",
                        "normalization", "seconds", "history"; "" for the report itself */
  const char* key;   /* its name within the group */
  emtr_field_type type;
  size_t offset;
  size_t rows; /* 1 for a single value and for a vector */
  size_t columns;
  size_t count_offset; /* 0 unless columns is 0 */
  const char* unit;    /* "" where it has none */
  const char* text;    /* one line */
} emtr_result_field_info;

/* The fields in the order in which a report shows them: all but `size` and `alternative_count`.
 * `size` as for emtr_setting_describe(). */
EMTR_API size_t emtr_result_field_count(void);
EMTR_API emtr_status emtr_result_field_describe(size_t index, emtr_result_field_info* info,
                                                size_t size);

/* Registers source to target. `settings` null: preset "default". `progress` may be null.
 * On EMTR_OK *result is new and to be freed, whether registered or not; on an error it is
 * set to null and emtr_error_message() tells more. */
EMTR_API emtr_status emtr_register(const emtr_cloud* source, const emtr_cloud* target,
                                   const emtr_settings* settings, emtr_progress_fn progress,
                                   void* user, emtr_result** result);

/* ---- residuals ---------------------------------------------------------------------- */

/* How far each point is from the other cloud, once `transformation` (source into target, null for
 * the identity) has moved the source: the distance to the nearest point, in the user's unit. Exact
 * to 1e-6 of the other cloud's size, or of the distance where that is larger, for clouds of any
 * shape with one finite point or more; NaN for points with a NaN or an infinity. of_source has room
 * for source->count numbers, of_target for target->count; null for what is not wanted. `threads` as
 * in the settings, without influence on the numbers. Asks nobody (emtr_set_interrupt()) while PCL
 * sorts the other cloud into a tree. */
EMTR_API emtr_status emtr_residuals(const emtr_cloud* source, const emtr_cloud* target,
                                    const double transformation[16], int32_t threads,
                                    double* of_source, double* of_target);

/* ---- one cloud, many partners ------------------------------------------------------- */

/* A cloud read, measured and, when it is large, thinned: what does not depend on its partner. It
 * never changes: many registrations may use one at the same time, as source and as target. */
typedef struct emtr_preprocessed emtr_preprocessed;

/* Keeps nothing of the caller's memory. `name` is put before " cloud" in error messages, null for
 * none; `threads` as in the settings, without influence on the result. On an error *prepared is
 * set to null. */
EMTR_API emtr_status emtr_preprocess(const emtr_cloud* cloud, const char* name, int32_t threads,
                                  emtr_preprocessed** preprocessed);
EMTR_API void emtr_preprocessed_free(emtr_preprocessed* preprocessed);

/* As emtr_register(), and keeps what it makes ready: a cloud whose *kept is not null is not read,
 * that one stands for it; else *kept receives what was prepared. Either pointer may be null, as
 * the cloud of one that is kept. What was prepared by the time of an error or a stop is kept too.
 */
EMTR_API emtr_status emtr_register_cached(const emtr_cloud* source, emtr_preprocessed** cached_source,
                                        const emtr_cloud* target, emtr_preprocessed** cached_target,
                                        const emtr_settings* settings, emtr_progress_fn progress,
                                        void* user, emtr_result** result);

typedef struct emtr_preprocessed_info {
  size_t points;    /* finite */
  size_t dropped;   /* with NaN or infinity */
  size_t kept;      /* points left by the thinning of a large cloud, else as many as `points` */
  double center[3]; /* centroid, user's unit */
  double radius;    /* largest distance from it, user's unit */
  int32_t normals;  /* 1: it came with normals */
  size_t described; /* points with features; of more than 200 000, those left by a thinning */
  size_t feature_dimension;
} emtr_preprocessed_info;

EMTR_API emtr_status emtr_preprocessed_describe(const emtr_preprocessed* preprocessed, emtr_preprocessed_info* info,
                                            size_t size);

/* As emtr_register(), to the same bits. `seconds_normalization` is without the preparation. */
EMTR_API emtr_status emtr_register_preprocessed(const emtr_preprocessed* source,
                                            const emtr_preprocessed* target,
                                            const emtr_settings* settings,
                                            emtr_progress_fn progress, void* user,
                                            emtr_result** result);

/* ---- stage by stage ----------------------------------------------------------------- */

/* A pair of clouds made ready: normalized, thinned, described, matched. For those who
 * bring their own optimiser. A particle of task alpha is (theta1, theta2, theta3, tx, ty,
 * tz), one of task beta (theta1, theta2, theta3): radians, R = Rz(theta1) Ry(theta2)
 * Rx(theta3), any real angle; t in the normalized frame. */
typedef struct emtr_problem emtr_problem;

/* Keeps nothing of the caller's memory. On an error *problem is set to null. The time limit does
 * not count here but in emtr_problem_solve(). */
EMTR_API emtr_status emtr_problem_create(const emtr_cloud* source, const emtr_cloud* target,
                                         const emtr_settings* settings, emtr_problem** problem);
/* Of prepared clouds, which may be freed before the problem. */
EMTR_API emtr_status emtr_problem_create_preprocessed(const emtr_preprocessed* source,
                                                  const emtr_preprocessed* target,
                                                  const emtr_settings* settings,
                                                  emtr_problem** problem);
EMTR_API void emtr_problem_free(emtr_problem* problem);

/* The evolution and the verdict on a problem; the timings count its making too, the time limit
 * does not. */
EMTR_API emtr_status emtr_problem_solve(emtr_problem* problem, emtr_progress_fn progress,
                                        void* user, emtr_result** result);

typedef enum emtr_stage { EMTR_STAGE_SPARSE = 0, EMTR_STAGE_DENSE = 1 } emtr_stage;

/* Fitness (sum, lower is better) of `count` particles, row-major (count, 6) and (count, 3).
 * Each look-up of alpha is counted on the problem. */
EMTR_API emtr_status emtr_task_alpha_evaluate(emtr_problem* problem, emtr_stage stage,
                                              const double* particles, size_t count,
                                              double* fitness);
EMTR_API emtr_status emtr_task_beta_evaluate(emtr_problem* problem, const double* particles,
                                             size_t count, double* fitness);

/* Algorithm 2: the translation (normalized frame) that completes a rotation, or, where priors are
 * set, the nearest rotation that they admit, to a pose that they admit. */
EMTR_API emtr_status emtr_complement(emtr_problem* problem, const double angles[3],
                                     double translation[3]);

/* Between a particle of task alpha and a 4x4 matrix in the user's unit. */
EMTR_API emtr_status emtr_particle_to_transformation(const emtr_problem* problem,
                                                     const double particle[6],
                                                     double transformation[16]);
EMTR_API emtr_status emtr_transformation_to_particle(const emtr_problem* problem,
                                                     const double transformation[16],
                                                     double particle[6]);

/* Look-ups of task alpha's evaluations and of the complement on this problem so far. */
EMTR_API uint64_t emtr_problem_queries(const emtr_problem* problem);

typedef struct emtr_problem_info {
  double normalization_scale; /* user's unit */
  double center_source[3];
  double center_target[3];
  double leaf_sparse; /* normalized frame, as all below */
  double leaf_dense;
  double c_sparse; /* scale of the M-estimator in either stage */
  double c_dense;
  double tau;
  size_t tims;        /* formed */
  size_t tims_pruned; /* of these, not kept in the arrays */
} emtr_problem_info;

EMTR_API emtr_status emtr_problem_describe(const emtr_problem* problem, emtr_problem_info* info,
                                           size_t size);

typedef enum emtr_array {
  EMTR_SOURCE_SPARSE = 0, /* float32 (n, 3), normalized frame, as all clouds below */
  EMTR_TARGET_SPARSE = 1,
  EMTR_SOURCE_DENSE = 2,
  EMTR_TARGET_DENSE = 3,
  EMTR_SOURCE_NORMALS = 4, /* float32 (n, 3), NaN where there is none */
  EMTR_TARGET_NORMALS = 5,
  EMTR_SOURCE_FEATURES = 6, /* float32 (n, 33) FPFH, NaN where there is none; or those that were
                               handed in; no rows when correspondences were */
  EMTR_TARGET_FEATURES = 7,
  EMTR_CORRESPONDENCES = 8, /* int32 (k, 2): rows of source and target feature points */
  EMTR_TIM_SOURCE = 9,      /* float32 (l, 3): p_k - p_j of those not pruned */
  EMTR_TIM_TARGET = 10,
  EMTR_SOURCE_FEATURE_POINTS = 11, /* float32 (n, 3): the points that are matched: the dense cloud,
                                      or those that features or correspondences were given for */
  EMTR_TARGET_FEATURE_POINTS = 12,
  EMTR_SOURCE_FEATURE_ROWS = 13, /* int32 (n, 1): their rows in the caller's array; no rows when
                                    it is the dense cloud */
  EMTR_TARGET_FEATURE_ROWS = 14
} emtr_array;

/* A view of one of the problem's arrays, row-major, valid until it is freed. */
EMTR_API emtr_status emtr_problem_array(const emtr_problem* problem, emtr_array which,
                                        const void** data, size_t* rows, size_t* columns);

#ifdef __cplusplus
}
#endif

#endif /* EMTR_EMTR_H */
