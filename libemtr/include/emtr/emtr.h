/* emtr: global registration of two partially overlapping point clouds by EMTR-SSC.
 *
 * The C API: plain structs and pointers, C99. It is the one ABI that is promised.
 * Most programs need five calls:
 *
 *   emtr_settings_init()  fills the settings with a preset
 *   emtr_register()       registers a source cloud to a target cloud
 *   emtr_error_message()  says why a call failed
 *   emtr_reason_text()    says why a pose is registered, or why not
 *   emtr_result_free()    frees a result
 *
 *   #include <emtr/emtr.h>
 *   #include <stdio.h>
 *
 *   int print_pose(const float* source, size_t n, const float* target, size_t m) {
 *     emtr_cloud from = {.points = source, .count = n, .scalar = EMTR_FLOAT32};
 *     emtr_cloud to = {.points = target, .count = m, .scalar = EMTR_FLOAT32};
 *     emtr_settings settings;
 *     emtr_result* result;
 *     int i;
 *     if (emtr_settings_init(&settings, sizeof settings, "fast") != EMTR_OK ||
 *         emtr_register(&from, &to, &settings, NULL, NULL, &result) != EMTR_OK) {
 *       fprintf(stderr, "%s\n", emtr_error_message());
 *       return 1;
 *     }
 *     printf("%s, confidence %.2f\n", emtr_reason_text(result->reason), result->confidence);
 *     for (i = 0; i < 16; ++i)
 *       printf("%.9g%c", result->transformation[i], i % 4 == 3 ? '\n' : ' ');
 *     emtr_result_free(result);
 *     return 0;
 *   }
 *
 * Direction: every transformation maps the SOURCE into the TARGET, q = R p + t. It is a 4x4
 * row-major array of double, and its translation is in the user's unit.
 * Normalized frame: p' = (p - center) / scale, in which both clouds are centered and the larger
 * one has radius 1. "Radii" as a unit means lengths in this frame.
 * Errors: a function that returns emtr_status reports every failure by it, and sets a pointer to a
 * new object to null.
 * Ownership: the library keeps no pointer to the caller's memory after a call. What it returns as
 * `const char*` is static, unless it is said otherwise.
 * Threads: all functions may be called from many threads at once, on separate objects. An object
 * that is passed as const may be shared.
 * Output: the library writes nothing to standard output or standard error.
 * Method: Wu et al., "Evolutionary Multitasking with Solution Space Cutting for Point Cloud
 * Registration", IEEE Transactions on Emerging Topics in Computational Intelligence, 2023. */
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

/* Marks fields that an initializer may leave out: C sets them to zero by itself. */
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
  EMTR_ERROR_ARGUMENT = 1,   /* a null pointer, a wrong size field, a bad stride or type */
  EMTR_ERROR_SETTING = 2,    /* an unknown setting, a value out of range, a contradiction */
  EMTR_ERROR_CLOUD = 3,      /* a cloud that cannot be registered: too few points, no extent */
  EMTR_ERROR_MEMORY = 4,     /* an allocation failed, on any thread */
  EMTR_ERROR_INTERNAL = 5,   /* a defect of the library or of a library that it uses */
  EMTR_ERROR_INTERRUPTED = 6 /* the function of emtr_set_interrupt() stopped the call */
} emtr_status;

/* Returns the message of this thread's last failed call. It names the cloud, the argument or the
 * setting, and what was expected. Never null; empty when no call has failed. The text is valid
 * until another call of this thread fails. */
EMTR_API const char* emtr_error_message(void);

/* Returns the general meaning of a status in a few words. Never null. */
EMTR_API const char* emtr_status_text(emtr_status status);

/* ---- cloud -------------------------------------------------------------------------- */

typedef enum emtr_scalar { EMTR_FLOAT32 = 0, EMTR_FLOAT64 = 1 } emtr_scalar;

/* Describes a cloud in the caller's memory: `count` points, each x, y, z side by side.
 *
 * A point lies `stride` bytes after the one before it; 0 means packed. No alignment is needed.
 * Points with a NaN or an infinity are dropped and counted. A cloud needs at least 10 finite
 * points, and 10 after downsampling (about 25 well spread ones suffice), that lie neither on one
 * point nor on one line.
 *
 * Normals and features are optional: null means none, so initialize the whole struct. They have
 * one row for each point.
 * Normals replace the estimated ones. Any length above 0 will do; a point whose normal has a NaN,
 * an infinity or length 0 has none. Where both clouds have normals, the features depend on the
 * side to which the normals point.
 * Features are descriptors of any kind. Both clouds have them or neither. They replace FPFH:
 * points that are each other's nearest neighbors by Euclidean distance become correspondences. A
 * point whose row has a NaN or an infinity is no keypoint. A cloud of more than 20 000 keypoints
 * is reduced to one keypoint in each dense leaf, the one nearest to its center.
 * Colors and intensities are optional too; see the setting use_colors. A point whose color has a
 * NaN or an infinity has none. A cloud that has colors needs no intensities: they are not read. */
typedef struct emtr_cloud {
  const void* points;
  size_t count;
  size_t stride;                      /* bytes, 0: packed */
  emtr_scalar scalar;                 /* type of the points and the normals */
  const void* normals EMTR_ZERO;      /* (count, 3) */
  size_t normal_stride EMTR_ZERO;     /* bytes, 0: packed */
  const float* features EMTR_ZERO;    /* (count, feature_dimension), row-major */
  size_t feature_dimension EMTR_ZERO; /* 1 to 65536 */
  size_t feature_stride EMTR_ZERO;    /* bytes, 0: packed */
  /* 1: preprocessing keeps all points, so that user-provided correspondences can name them. It
   * matters only for clouds of more than 200 000 points, at 12 bytes each: smaller clouds always
   * keep theirs */
  int32_t keep_points EMTR_ZERO;
  const float* colors EMTR_ZERO;      /* (count, 3): red, green, blue, 0 to 1 */
  size_t color_stride EMTR_ZERO;      /* bytes, 0: packed */
  const float* intensities EMTR_ZERO; /* (count), not below 0, in any unit */
  size_t intensity_stride EMTR_ZERO;  /* bytes, 0: packed */
} emtr_cloud;

/* ---- settings ----------------------------------------------------------------------- */

/* Says when a part of the method acts: fallback_search, rotation_vector_steps, arc_transfer. */
typedef enum emtr_when {
  EMTR_OFF = 0,
  EMTR_AUTO = 1, /* where the setting's comment says that it helps */
  EMTR_ALWAYS = 2
} emtr_when;

/* Chooses what computes normals and FPFH: PCL's functions, or vectorized code of the same
 * definition. */
typedef enum emtr_features { EMTR_FEATURES_PCL = 0, EMTR_FEATURES_SIMD = 1 } emtr_features;

/* Chooses what answers the nearest-neighbor queries of the fitness. The results have the same bits.
 */
typedef enum emtr_neighbors {
  EMTR_NEIGHBORS_GRID = 0,
  EMTR_NEIGHBORS_KDTREE = 1, /* PCL's kd-tree */
  EMTR_NEIGHBORS_BRUTE_FORCE = 2
} emtr_neighbors;

/* Chooses the points in which task alpha's dense stage looks for neighbors. */
typedef enum emtr_reference {
  EMTR_REFERENCE_DENSE = 0, /* those of the dense clouds */
  EMTR_REFERENCE_WHOLE = 1  /* those of the whole clouds, before downsampling; c is then at least
                               two of their spacings */
} emtr_reference;

/* Chooses the scales of the source's lengths that are searched. */
typedef enum emtr_scale {
  EMTR_SCALE_FIXED = 0, /* none: both clouds have one unit, and the transformation is rigid */
  EMTR_SCALE_FREE = 1,  /* any */
  EMTR_SCALE_BOUNDED =
      2,               /* from scale_minimum to scale_maximum; one number, if these are the same */
  EMTR_SCALE_UNITS = 3 /* factors between units: 1, 10, 12, 25.4, 100, 304.8, 1000, and 1 over
                          these */
} emtr_scale;

/* Fill it by emtr_settings_init(), then change single fields.
 *
 * The command line and Python use the same names. Lengths are multiples of a leaf, of the
 * resolution, or of the radius of the normalized frame, so that they fit clouds in any unit. Only
 * the priors at the end are in the user's unit. emtr_setting_describe() gives the unit, range,
 * default and meaning of each setting. */
typedef struct emtr_settings {
  size_t size;       /* sizeof(emtr_settings), set by emtr_settings_init() */
  uint64_t seed;     /* any number; the same seed gives the same bits */
  int32_t threads;   /* 0: as many as OpenMP would use; no number changes the result */
  double time_limit; /* seconds, 0: none. A run that takes longer returns its best pose so far */

  /* downsampling */
  int32_t dense_points;        /* of both dense clouds together */
  int32_t coarse_points;       /* as dense_points, for a coarse search first; 0: none */
  int32_t sparse_points;       /* of the sparse source cloud */
  double minimum_leaf_spacing; /* least dense leaf, point spacings */
  double maximum_leaf_growth;  /* of the dense leaf, where a cloud lies along curves */
  int32_t leaf_ladder;         /* leaves and the scale are rounded to eight lengths an octave */

  /* features and correspondences */
  double normal_radius;        /* dense leaves */
  double feature_radius;       /* dense leaves */
  int32_t features;            /* an emtr_features */
  int32_t max_correspondences; /* keeps those with the nearest descriptors */
  int32_t max_tims;            /* most pairs of correspondences */

  /* seeds: poses on which spatially consistent correspondences agree */
  int32_t seeds;          /* 0: none */
  double seed_threshold;  /* dense leaves */
  int32_t injected_seeds; /* particles of each swarm that start at a seed */

  /* task beta */
  double tau_factor;       /* tau / mean resolution of the dense clouds */
  double inlier_threshold; /* tau */
  double outlier_penalty;  /* eta, tau */

  /* task alpha */
  double scale_sparse;      /* c of the sparse stage, sparse leaves */
  double scale_dense;       /* c of the dense stage, dense leaves */
  int32_t dense_reference;  /* an emtr_reference */
  double translation_bound; /* half the side of the search box, radii */

  /* swarm */
  int32_t population; /* particles of each task */
  int32_t iterations; /* MaxIt */
  /* with seeds and candidates: the evolution ends once its best pose has stayed in one place for so
   * many iterations; 0: never before MaxIt */
  int32_t stall_iterations;
  double inertia_start;
  double inertia_end;
  double cognitive;      /* c1 */
  double social;         /* c2 */
  double velocity_limit; /* share of each gene's range */
  /* an emtr_when: rotations step by rotation vectors, in the tangent space of SO(3), instead of by
   * Euler angles. EMTR_AUTO: where no particle starts at a seed. A prior that limits the rotation
   * has genes of its own, which this leaves alone */
  int32_t rotation_vector_steps;

  /* knowledge transfer and knowledge complement (Algorithm 2) */
  int32_t transfer;            /* 0: the tasks exchange nothing (ablation) */
  double transfer_probability; /* rmp */
  /* an emtr_when: the rotation of a guide lies on the shortest arc between the two bests instead
   * of between their angles. EMTR_AUTO: where no particle starts at a seed */
  int32_t arc_transfer;
  double lambda_alpha_start;
  double lambda_alpha_end;
  double lambda_beta_start;
  double lambda_beta_end;
  int32_t complement;            /* 0: alpha keeps its own translation (ablation) */
  int32_t complement_iterations; /* MaxIt_KC */
  double complement_scale_start; /* d, radii */
  double complement_scale_end;   /* radii */

  /* sparse to dense */
  int32_t sparse_to_dense; /* 0: the dense stage throughout (ablation) */
  double switch_fraction;  /* delta */

  int32_t neighbors; /* an emtr_neighbors */

  /* candidates: seeds and the best poses of the swarm, refined locally and ranked on the
   * surfaces */
  int32_t candidates;      /* 0: the swarm's best pose is the answer */
  int32_t free_space;      /* 0: points in front of what the other scan saw cost nothing */
  int32_t distinctiveness; /* 0: all points count alike in the score (ablation) */
  int32_t rivals; /* 0: adds no poses that a symmetric scene would fit as well (ablation) */

  /* fallback search: more feature points, both signs of the normals, more candidates */
  int32_t fallback_search; /* an emtr_when; EMTR_AUTO: below fallback_confidence */
  double fallback_confidence;
  int32_t fallback_points; /* of both clouds together */
  int32_t fallback_correspondences;
  int32_t fallback_seeds;
  int32_t fallback_candidates;
  int32_t plane_aligned_poses; /* most poses that lay a plane on a plane; 0: none */
  int32_t parts;               /* of the larger cloud that are tried where sizes differ; 0: none */

  /* refinement of the answer on the fine clouds */
  int32_t refine;     /* 0: off */
  int32_t use_colors; /* an emtr_when, for the colors or intensities of both clouds; EMTR_AUTO:
                       * where their shape leaves the pose open, EMTR_ALWAYS: everywhere, and clouds
                       * without colors are an error */
  double refine_leaf; /* radii */

  /* unknown scale of the source: then the transformation is a similarity, q = s R p + t, and the
   * priors and the guess speak of its R and t */
  int32_t scale; /* an emtr_scale */
  double scale_minimum;
  double scale_maximum;
  int32_t task_gamma; /* 0: no votes for scales, only even steps (ablation) */

  /* verdict */
  double maximum_fitness;
  double minimum_fitness_gap;
  double minimum_confidence;

  /* Guess: a pose to try as one hypothesis among the particles, row-major, source into target,
   * user's unit. The search stays near it only where guess_rotation or guess_translation say so.
   * If the priors do not admit it, the nearest admitted pose takes its place */
  int32_t has_guess;
  double guess[16];

  /* Viewpoints: the sensor's position in each cloud's own frame and unit. Where has_... is 0 the
   * position is unknown, and estimated if it is needed */
  int32_t has_viewpoint_source;
  double viewpoint_source[3];
  int32_t has_viewpoint_target;
  double viewpoint_target[3];

  /* Priors: what is known of the pose. All of them hold at once, for every pose that is tried, and
   * up to rounding for the transformation and the alternatives of the result. Priors that admit no
   * pose are an EMTR_ERROR_SETTING that names them. Lengths are in the user's unit. */
  double guess_rotation;    /* degrees, most angle to the guess's rotation; 180: any */
  double guess_translation; /* user's unit, most distance between where the pose and where the
                               guess put the source's centroid; 1e12: any */
  int32_t has_axis;         /* 1: only rotations about the axis */
  double axis[3];           /* direction, the same in both clouds' frames, of any length > 0; for
                               example "up" for scanners that measure it */
  double axis_tilt;         /* degrees, most angle between the axis and the rotated axis */
  /* degrees about the axis by the right-hand rule; -180 to 180: any. If the rotation also tilts
   * the axis, the rotation before the tilt counts */
  double axis_angle_minimum;
  double axis_angle_maximum;
  int32_t has_translation_bounds;
  /* user's unit, finite: limits of the translation in the result's matrix, which is where the
   * source's origin ends */
  double translation_minimum[3];
  double translation_maximum[3];
  double maximum_rotation; /* degrees of the whole rotation; 180: any */

  /* User-provided correspondences replace the library's own; null: none. (correspondence_count, 2)
   * row-major: a row of the source's points and a row of the target's. At least 3 different ones
   * of finite points are needed. Above max_correspondences that many are taken, evenly spread over
   * the list. The library reads them during the call only */
  const int32_t* correspondences;
  size_t correspondence_count;
} emtr_settings;

/* Fills *settings with a preset: "default" (also for null), "fast", "thorough", or "paper", the
 * method as published. `size` is sizeof(emtr_settings) as the caller was compiled.
 * Errors: EMTR_ERROR_SETTING for an unknown preset, EMTR_ERROR_ARGUMENT for another size. */
EMTR_API emtr_status emtr_settings_init(emtr_settings* settings, size_t size, const char* preset);

/* ---- registration ------------------------------------------------------------------- */

typedef struct emtr_progress {
  const char* stage;  /* one of emtr_stage_name() */
  int32_t iteration;  /* iterations done, in "evolution"; else 0 */
  int32_t iterations; /* iterations in all */
  double best_alpha;  /* best fitness of task alpha, lower is better */
  double best_beta;   /* best fitness of task beta */
} emtr_progress;

/* Returns the name of a stage, in the order in which they run: "normalization", "downsampling",
 * "features", "matching", "seeds", "evolution", "candidates", "fallback_search", "refinement",
 * "verdict". Null past the last. */
EMTR_API const char* emtr_stage_name(size_t index);

/* Returns non-zero to STOP the run. The run ends within 100 ms; its result has the best pose so far
 * and the reason EMTR_REASON_INTERRUPTED.
 * Stages that a coarse search has passed begin again where a finer one follows.
 * The library calls it on the caller's thread, with the `user` pointer of the call: before each
 * stage, after each iteration, and about every 20 ms while a stage lasts, then with the same
 * progress again. It may call the library, except on the problem that is being solved. It sees the
 * default floating-point environment. If it throws (in C++), the call fails with
 * EMTR_ERROR_INTERNAL. */
typedef int (*emtr_progress_fn)(const emtr_progress* progress, void* user);

typedef enum emtr_reason {
  EMTR_REASON_REGISTERED = 0,
  EMTR_REASON_LOW_OVERLAP = 1, /* too few points of the clouds lie on each other */
  EMTR_REASON_AMBIGUOUS = 2,   /* another, clearly different pose fits about as well */
  EMTR_REASON_FEW_MATCHES = 3, /* too few correspondences, or too few that agree */
  EMTR_REASON_INTERRUPTED = 4, /* the progress function stopped the run */
  EMTR_REASON_DEGENERATE = 5,  /* the surfaces leave a motion along themselves unconstrained */
  EMTR_REASON_TIME_LIMIT = 6,  /* the setting time_limit stopped the run */
  EMTR_REASON_MIRRORED = 7,    /* the mirror image of the source fits better */
  EMTR_REASON_SCALE = 8,       /* the source fits better at another scale: see scale_factor */
  EMTR_REASON_FREE_SCALE = 9   /* a pose was found, but the surfaces leave the scale open */
} emtr_reason;

/* Another pose that the clouds could have. */
typedef struct emtr_alternative {
  double transformation[16]; /* source into target, row-major, user's unit */
  double score;              /* as in the result, never above the answer's */
  double surface_fit;        /* as in the result; NaN where the matches alone decide, as below */
  double violation;          /* as in the result */
  double evidence;           /* as in the result */
} emtr_alternative;

/* The library owns it and all that it points to; emtr_result_free() frees it. Later versions append
 * fields. */
typedef struct emtr_result {
  size_t size; /* sizeof(emtr_result) as the library was compiled */

  double transformation[16]; /* source into target, row-major, user's unit, R orthonormal, times
                                the scale where that was searched. If the
                                run was stopped (reasons INTERRUPTED and TIME_LIMIT): the best pose
                                so far, all NaN if none was known */
  int32_t registered;        /* 1: the pose is probably right; 0: it is doubtful */
  emtr_reason reason;

  /* quality on the dense clouds */
  double fitness;             /* mean of rho over both dense clouds, 0 (best) to 1 */
  double inlier_ratio_source; /* share of dense source points within c of the target */
  double inlier_ratio_target; /* share of dense target points within c of the source */
  double fitness_gap; /* fitness of the best clearly different pose (by more than 10 degrees or
                         0.15 radii) minus the fitness of this pose */

  /* quality on the fine clouds, which are downsampled by leaf_fine. The correspondence of a point
   * is the nearest fine point of the other cloud within leaf_fine. At most 5000 points of each
   * cloud, evenly spread over its order, are asked. NaN when interrupted */
  double overlap_source; /* share of the source's points that have a correspondence */
  double overlap_target; /* share of the target's points that have a correspondence */
  double inlier_rmse;    /* user's unit: root mean square distance of the source's points to their
                            correspondences; NaN if there are none */
  double inlier_rmse_plane; /* user's unit: the same to the tangent planes of the correspondences;
                               it does not grow with the spacing of the points */

  /* counts */
  size_t points_source; /* finite points */
  size_t points_target;
  size_t dropped_source; /* points with a NaN or an infinity */
  size_t dropped_target;
  size_t sparse_source; /* points of the downsampled clouds */
  size_t sparse_target;
  size_t dense_source;
  size_t dense_target;
  size_t correspondences; /* at most max_correspondences */
  size_t tims;            /* formed, at most max_tims */
  size_t tims_pruned;     /* of these, inliers of no rotation, which need no work */

  /* nearest-neighbor queries, the cost that the paper counts */
  uint64_t queries_evaluation; /* of the particles */
  uint64_t queries_switch;     /* of the pbests, evaluated again at the switch to dense */
  uint64_t queries_complement; /* of Algorithm 2 */

  /* the normalized frame: p' = (p - center) / normalization_scale */
  double normalization_scale; /* user's unit */
  double center_source[3];    /* user's unit */
  double center_target[3];
  double leaf_sparse; /* radii */
  double leaf_dense;
  double leaf_fine; /* NaN when interrupted */

  /* wall time, seconds; 0 for a stage that did not run */
  double seconds_normalization; /* with the preprocessing that this call did */
  double seconds_downsampling;
  double seconds_features;
  double seconds_matching;
  double seconds_evolution;
  double seconds_verdict;
  double seconds_total;

  /* best fitness of both tasks after each iteration; the scale of alpha changes at the switch */
  size_t iterations;           /* done */
  const double* history_alpha; /* (iterations) */
  const double* history_beta;  /* (iterations) */

  uint64_t seed;
  int32_t threads;    /* asked for; OpenMP may have given fewer */
  const char* kernel; /* as emtr_kernel_name() */

  /* the answer among the candidates */
  double confidence;  /* estimated probability that the pose is right (within 5 degrees and 0.06
                         radii), 0 to 1 in steps of 1e-6. NaN without candidates, and if the run was
                         stopped before all candidates were ranked; so are the next four */
  double score;       /* surface_fit - 0.1 (surface_near - surface_fit) - violation, at most 1 */
  double surface_fit; /* surface-fit score: how well the surfaces lie on each other, weighted by
                         how distinctive each point is, 0 to 1 (best) */
  double violation;   /* share of points in front of what the other scan saw, times the trust in the
                         sensor's place */
  double score_gap;   /* score minus the score of the best clearly different candidate */
  size_t seeds;       /* poses that consistent correspondences gave, in all searches */
  size_t candidates;  /* different poses that were ranked */
  int32_t used_fallback_search;         /* 1: the fallback search ran */
  int32_t refined;                      /* 1: the pose was refined on the fine clouds */
  size_t alternative_count;             /* at most 10 */
  const emtr_alternative* alternatives; /* clearly different poses, best first */

  /* Information matrix (6, 6), row-major: the inverse covariance of a small rotation w (radians)
   * and then a translation v (user's unit), q = exp(w) (R p + t - c) + c + v with c =
   * center_target. NaN when not refined */
  double information[36];
  /* Eigenvalues of the Hessian, ascending: how strongly the matched surfaces constrain each
   * direction of motion, 0 (they leave it unconstrained) to about 1. Rotations are measured at the
   * surfaces' radius. NaN when not refined */
  double hessian_eigenvalues[6];
  double hessian_eigenvectors[36];  /* unit vectors, one a row: rotation at that radius, then
                                       translation */
  int32_t unconstrained_directions; /* how many; -1 when not refined */

  double seconds_seeds;
  double seconds_candidates;
  double seconds_fallback_search;
  double seconds_refinement;

  size_t correspondences_found; /* before max_correspondences applies */

  double surface_near; /* share of points near the other surface, weighted as surface_fit */
  double evidence;     /* how many dense points of the poorer cloud lie on the other */
  double scale_factor; /* of the source's lengths, at which it fits better; 1 where none does */

  /* finite points that were left out: far outside of all the others or, in a cloud of at most 3000
   * points, scattered off its surface */
  size_t strays_source;
  size_t strays_target;

  /* A motion of what both clouds show together, after which they fit about as well: "none";
   * "rotational" (by 360 / symmetry_order degrees about symmetry_axis), "continuous" (by any angle
   * about it), "translational" (by symmetry_period along it). "unknown" without candidates, and if
   * the run was stopped before they were ranked */
  const char* symmetry;
  int32_t symmetry_order;  /* 0 unless rotational */
  double symmetry_axis[3]; /* in the target's axes, unit length; NaN where there is no symmetry */
  double symmetry_period;  /* user's unit; 0 where any length is one; NaN unless translational */

  /* of the source's lengths: q = scale R p + t. 1 where it was not searched; NaN when no pose is
   * known */
  double scale;
  /* How strongly the surfaces constrain the scale, 0 (a plane, a cone or a corner of planes, which
   * leave it open) to about 1 (a sphere). NaN where it was not searched or refined */
  double scale_constraint;
  /* Information matrix (7, 7), row-major, of a similarity: as `information` for the first six, then
   * the logarithm of the scale about center_target, q = e^l exp(w) (s R p + t - c) + c + v. NaN
   * where the scale was not searched or refined */
  double information_similarity[49];
  double seconds_scale_search;
  /* by use_colors */
  int32_t used_colors;      /* 1: colors decided about the pose, or took part in its refinement */
  double color_correlation; /* of the colors of both clouds where they overlap, -1 to 1; NaN where
                               they were not looked at, or tell nothing */
  double color_evidence;    /* logarithm of the likelihood of these colors under the pose by that of
                               unrelated ones; NaN as above */
} emtr_result;

/* Registers the source to the target.
 * `settings`: null for preset "default". `progress`: null for none; `user` is passed to it.
 * On EMTR_OK *result is new, whether registered or not, and the caller frees it by
 * emtr_result_free(). On an error *result is null.
 * Errors: EMTR_ERROR_CLOUD, EMTR_ERROR_SETTING, EMTR_ERROR_ARGUMENT, EMTR_ERROR_MEMORY. */
EMTR_API emtr_status emtr_register(const emtr_cloud* source, const emtr_cloud* target,
                                   const emtr_settings* settings, emtr_progress_fn progress,
                                   void* user, emtr_result** result);

/* Frees a result; does nothing for null. */
EMTR_API void emtr_result_free(emtr_result* result);

/* Returns the meaning of a reason in a few words. Never null. */
EMTR_API const char* emtr_reason_text(emtr_reason reason);

/* Returns the short name of a reason, which no version changes: "registered", "low_overlap",
 * "ambiguous", "few_matches", "interrupted", "degenerate", "time_limit", "mirrored", "scale",
 * "free_scale".
 * "unknown" for any other number. */
EMTR_API const char* emtr_reason_name(emtr_reason reason);

/* ---- result fields by name ---------------------------------------------------------- */

typedef enum emtr_field_type {
  EMTR_FIELD_REAL = 0,       /* double */
  EMTR_FIELD_INT32 = 1,      /* int32_t, -1 where there is none */
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
  const char* unit;    /* "" for none */
  const char* text;    /* one line */
} emtr_result_field_info;

/* Returns the number of fields that a report shows: all but `size` and `alternative_count`. */
EMTR_API size_t emtr_result_field_count(void);

/* Describes the field at `index`, in the order in which a report shows them. `size` as for
 * emtr_setting_describe().
 * Errors: EMTR_ERROR_ARGUMENT for an index past the last, or a smaller size. */
EMTR_API emtr_status emtr_result_field_describe(size_t index, emtr_result_field_info* info,
                                                size_t size);

/* ---- settings by name --------------------------------------------------------------- */

/* Returns the name of a preset, null past the last. */
EMTR_API const char* emtr_preset_name(size_t index);

typedef enum emtr_setting_type {
  EMTR_SETTING_INTEGER = 0,
  EMTR_SETTING_REAL = 1,
  EMTR_SETTING_SWITCH = 2, /* 0 or 1 */
  EMTR_SETTING_CHOICE = 3  /* a value of an enum, named by `choices` */
} emtr_setting_type;

typedef struct emtr_setting_info {
  const char* name;
  emtr_setting_type type;
  const char* unit;    /* "" for none */
  double minimum;      /* inclusive */
  double maximum;      /* inclusive */
  double value;        /* in preset "default" */
  const char* part;    /* the part of the method that it belongs to, "" for none */
  const char* text;    /* one line */
  const char* choices; /* names of the values 0, 1, ..., comma separated; "" unless a CHOICE */
} emtr_setting_info;

/* Returns the number of settings that have a name: all but `size`, the vectors with their has_...,
 * and the correspondences. */
EMTR_API size_t emtr_setting_count(void);

/* Describes the setting at `index`; the order is that of the library's table, and fixed.
 * `size` is sizeof(*info) as the caller was compiled. Later versions append fields: a larger size
 * gets zeros in the fields that this library does not know, a smaller one is an error. All
 * functions that fill an info struct do so.
 * Errors: EMTR_ERROR_ARGUMENT for an index past the last, or a smaller size. */
EMTR_API emtr_status emtr_setting_describe(size_t index, emtr_setting_info* info, size_t size);

/* Sets a setting by its name and checks its range. Contradictions between settings are found when
 * the settings are used. A seed above 2^53 has no exact double: set it in the struct.
 * Errors: EMTR_ERROR_SETTING for an unknown name or a value out of range. */
EMTR_API emtr_status emtr_setting_set(emtr_settings* settings, const char* name, double value);

/* Reads a setting by its name into *value.
 * Errors: EMTR_ERROR_SETTING for an unknown name. */
EMTR_API emtr_status emtr_setting_get(const emtr_settings* settings, const char* name,
                                      double* value);

/* ---- library ------------------------------------------------------------------------ */

/* Returns the version of the library, "major.minor.patch". */
EMTR_API const char* emtr_version(void);

/* Returns the instruction set of the inner loops: "generic", "avx2" or "avx512". It is the fastest
 * that the machine has, or the one that the environment variable EMTR_KERNEL asks for. The result
 * has the same bits with each. Null, with an error message, if EMTR_KERNEL asks for one that this
 * machine cannot run; a registration then fails with EMTR_ERROR_SETTING. */
EMTR_API const char* emtr_kernel_name(void);

/* Returns non-zero to STOP the call that is running. It may call the library; those calls are not
 * interrupted. */
typedef int (*emtr_interrupt_fn)(void* user);

/* Sets the function that this thread's calls without a progress function ask about every 20 ms
 * whether to stop. A registration then ends with the reason EMTR_REASON_INTERRUPTED, any other call
 * fails with EMTR_ERROR_INTERRUPTED. Null, the default, for none. `user` is passed to it. */
EMTR_API void emtr_set_interrupt(emtr_interrupt_fn interrupt, void* user);

/* ---- residuals ---------------------------------------------------------------------- */

/* Measures the distance of each point to the nearest point of the other cloud, user's unit, after
 * `transformation` (source into target, row-major; null: identity) has moved the source.
 * `source_residuals` has room for source->count numbers, `target_residuals` for target->count;
 * either may be null. Points with a NaN or an infinity get NaN. The distances are exact to 1e-6 of
 * the other cloud's size, or of the distance if that is larger. One finite point in each cloud
 * suffices, in any shape. `threads` as in the settings; no number changes the result.
 * The transformation may have a scale, as that of a result has; the distances are in the target's
 * unit. Errors: EMTR_ERROR_ARGUMENT for one that is no similarity,
 * EMTR_ERROR_SETTING for `threads`, EMTR_ERROR_CLOUD. While PCL builds its kd-tree the call cannot
 * be interrupted. */
EMTR_API emtr_status emtr_residuals(const emtr_cloud* source, const emtr_cloud* target,
                                    const double transformation[16], int32_t threads,
                                    double* source_residuals, double* target_residuals);

/* ---- preprocessed clouds: one target for many sources ------------------------------- */

/* A cloud that was read, measured and, if it is large, downsampled: all work that does not depend
 * on the other cloud. It never changes, so many registrations may use it at once, as source and as
 * target. While it is one of the sixteen of the process that were used last, it remembers what a
 * registration made of it, in 5 to 15 MB, for the next one. */
typedef struct emtr_preprocessed emtr_preprocessed;

/* Preprocesses a cloud. `name` begins the error messages, as in "<name> cloud: ..."; null for none.
 * `threads` as in the settings; no number changes the result.
 * On EMTR_OK *preprocessed is new, and the caller frees it by emtr_preprocessed_free(). On an error
 * it is null.
 * Errors: EMTR_ERROR_CLOUD, EMTR_ERROR_ARGUMENT, EMTR_ERROR_SETTING for `threads`. */
EMTR_API emtr_status emtr_preprocess(const emtr_cloud* cloud, const char* name, int32_t threads,
                                     emtr_preprocessed** preprocessed);

/* Frees a preprocessed cloud; does nothing for null. Problems made of it stay valid. */
EMTR_API void emtr_preprocessed_free(emtr_preprocessed* preprocessed);

/* Registers two preprocessed clouds as emtr_register() does, with the same bits.
 * `seconds_normalization` does not count the preprocessing. */
EMTR_API emtr_status emtr_register_preprocessed(const emtr_preprocessed* source,
                                                const emtr_preprocessed* target,
                                                const emtr_settings* settings,
                                                emtr_progress_fn progress, void* user,
                                                emtr_result** result);

/* Registers two clouds as emtr_register() does, and caches their preprocessing.
 * Where *cached_source is not null, it is used and `source` is not read; `source` may be null then.
 * Where it is null, it receives the preprocessed cloud, also when the run fails or is stopped
 * afterwards; the caller frees it by emtr_preprocessed_free(). A null cached_source caches nothing.
 * The same holds for the target. */
EMTR_API emtr_status emtr_register_cached(const emtr_cloud* source,
                                          emtr_preprocessed** cached_source,
                                          const emtr_cloud* target,
                                          emtr_preprocessed** cached_target,
                                          const emtr_settings* settings, emtr_progress_fn progress,
                                          void* user, emtr_result** result);

typedef struct emtr_preprocessed_info {
  size_t points;      /* finite points */
  size_t dropped;     /* points with a NaN or an infinity */
  size_t base_points; /* points left after a large cloud was downsampled, else all `points` */
  double center[3];   /* centroid, user's unit */
  double radius;      /* largest distance from the centroid, user's unit */
  int32_t normals;    /* 1: the user provided normals */
  size_t keypoints;   /* points with user-provided features; of more than 200 000, those that are
                         left after downsampling */
  size_t feature_dimension; /* 0: no features */
  size_t strays;            /* finite points that are left out, see emtr_result */
} emtr_preprocessed_info;

/* Describes a preprocessed cloud. `size` as for emtr_setting_describe(). */
EMTR_API emtr_status emtr_preprocessed_describe(const emtr_preprocessed* preprocessed,
                                                emtr_preprocessed_info* info, size_t size);

/* ---- stage by stage: for another optimizer ------------------------------------------ */

/* A pair of clouds that was normalized, downsampled and matched, with the two tasks of the method.
 * A particle of task alpha is (theta1, theta2, theta3, tx, ty, tz), one of task beta (theta1,
 * theta2, theta3): R = Rz(theta1) Ry(theta2) Rx(theta3) in radians, any real angles; t in radii.
 * One thread at a time may call the functions that change it. */
typedef struct emtr_problem emtr_problem;

/* Creates a problem of two clouds. `settings`: null for preset "default". The time limit does not
 * act here but in emtr_problem_solve().
 * On EMTR_OK *problem is new, and the caller frees it by emtr_problem_free(). On an error it is
 * null. Errors: as emtr_register(), and EMTR_ERROR_INTERRUPTED. */
EMTR_API emtr_status emtr_problem_create(const emtr_cloud* source, const emtr_cloud* target,
                                         const emtr_settings* settings, emtr_problem** problem);

/* Creates a problem of two preprocessed clouds, which may be freed before the problem. */
EMTR_API emtr_status emtr_problem_create_preprocessed(const emtr_preprocessed* source,
                                                      const emtr_preprocessed* target,
                                                      const emtr_settings* settings,
                                                      emtr_problem** problem);

/* Frees a problem; does nothing for null. */
EMTR_API void emtr_problem_free(emtr_problem* problem);

/* Solves a problem: from the seeds to the verdict, with the bits of emtr_register() without a
 * coarse search (setting `coarse_points` 0). The timings count the creation of the problem too; the
 * time limit does not.
 * On EMTR_OK *result is new, and the caller frees it. On an error it is null. */
EMTR_API emtr_status emtr_problem_solve(emtr_problem* problem, emtr_progress_fn progress,
                                        void* user, emtr_result** result);

/* Solves a problem by poses that were found elsewhere, in the place of those of the swarm: the best
 * of them become candidates beside the guess, the seeds and the poses of the correspondences, and
 * all goes on as in emtr_problem_solve(). So the pose of the result may be another one; without
 * seeds (setting `seeds`) and without fallback search it is one of them, or a rival beside it.
 * `transformations` is (count, 16), source into target, row-major, user's unit, count > 0. With
 * priors each is moved to the nearest pose that they admit. Where the user's correspondences
 * decide, the poses play no part. On EMTR_OK *result is new, and the caller frees it. On an error
 * it is null. Errors: EMTR_ERROR_ARGUMENT for a transformation that is not rigid, by its row. */
EMTR_API emtr_status emtr_problem_solve_from(emtr_problem* problem, const double* transformations,
                                             size_t count, emtr_progress_fn progress, void* user,
                                             emtr_result** result);

/* Scores poses as candidates are scored, each where it is: nothing is refined. Writes them to
 * scored[count], in their order, with their transformations.
 * Errors: EMTR_ERROR_ARGUMENT as emtr_problem_solve_from(), EMTR_ERROR_SETTING for a problem
 * without candidates. */
EMTR_API emtr_status emtr_problem_score(const emtr_problem* problem, const double* transformations,
                                        size_t count, emtr_alternative* scored);

/* Refines poses on the fine clouds, as the answer is refined, and writes them to `refined`, (count,
 * 16). A pose that cannot be refined, because too few points are near, stays where it is. With
 * priors each is first moved to the nearest pose that they admit, and stays among these.
 * Errors: EMTR_ERROR_ARGUMENT as emtr_problem_solve_from(). */
EMTR_API emtr_status emtr_problem_refine(const emtr_problem* problem, const double* transformations,
                                         size_t count, double* refined);

/* The downsampled clouds on which task alpha is evaluated. */
typedef enum emtr_resolution {
  EMTR_RESOLUTION_SPARSE = 0,
  EMTR_RESOLUTION_DENSE = 1
} emtr_resolution;

/* Evaluates task alpha: writes the fitness (a sum, lower is better) of `count` particles, (count,
 * 6) row-major, to fitness[count]. The problem counts the nearest-neighbor queries. Errors:
 * EMTR_ERROR_ARGUMENT for a number that is not finite or beyond 1e6. */
EMTR_API emtr_status emtr_task_alpha_evaluate(emtr_problem* problem, emtr_resolution resolution,
                                              const double* particles, size_t count,
                                              double* fitness);

/* Evaluates task beta: writes the fitness of `count` particles, (count, 3) row-major, to
 * fitness[count]. Errors: as emtr_task_alpha_evaluate(). */
EMTR_API emtr_status emtr_task_beta_evaluate(emtr_problem* problem, const double* particles,
                                             size_t count, double* fitness);

/* Runs Algorithm 2: writes the translation (radii) that completes a rotation to a pose. With priors
 * it takes the nearest rotation that they admit, and completes it to a pose that they admit. The
 * problem counts the nearest-neighbor queries. Errors: as emtr_task_alpha_evaluate(). */
EMTR_API emtr_status emtr_complement(emtr_problem* problem, const double angles[3],
                                     double translation[3]);

/* Converts a particle of task alpha to a transformation (source into target, user's unit).
 * Errors: as emtr_task_alpha_evaluate(). */
EMTR_API emtr_status emtr_particle_to_transformation(const emtr_problem* problem,
                                                     const double particle[6],
                                                     double transformation[16]);

/* Converts a transformation (source into target, user's unit) to a particle of task alpha.
 * Errors: EMTR_ERROR_ARGUMENT for a transformation that is not rigid. */
EMTR_API emtr_status emtr_transformation_to_particle(const emtr_problem* problem,
                                                     const double transformation[16],
                                                     double particle[6]);

/* Returns the number of nearest-neighbor queries of emtr_task_alpha_evaluate() and
 * emtr_complement() on this problem so far; 0 for null. */
EMTR_API uint64_t emtr_problem_queries(const emtr_problem* problem);

typedef struct emtr_problem_info {
  double normalization_scale; /* user's unit */
  double center_source[3];    /* user's unit */
  double center_target[3];
  double leaf_sparse; /* radii, as the next four */
  double leaf_dense;
  double c_sparse; /* scale of the M-estimator in the sparse stage */
  double c_dense;  /* scale of the M-estimator in the dense stage */
  double tau;
  size_t tims;        /* formed */
  size_t tims_pruned; /* of these, left out of the arrays */
} emtr_problem_info;

/* Describes a problem. `size` as for emtr_setting_describe(). */
EMTR_API emtr_status emtr_problem_describe(const emtr_problem* problem, emtr_problem_info* info,
                                           size_t size);

typedef enum emtr_array {
  EMTR_SOURCE_SPARSE = 0, /* float32 (n, 3), radii, as all clouds below */
  EMTR_TARGET_SPARSE = 1,
  EMTR_SOURCE_DENSE = 2,
  EMTR_TARGET_DENSE = 3,
  EMTR_SOURCE_NORMALS = 4, /* float32 (n, 3), NaN for a point without a normal */
  EMTR_TARGET_NORMALS = 5,
  EMTR_SOURCE_FEATURES = 6, /* float32 (n, 33): FPFH, NaN for a point without; or (n, dimension):
                               user-provided features; no rows with user-provided
                               correspondences */
  EMTR_TARGET_FEATURES = 7,
  EMTR_CORRESPONDENCES = 8, /* int32 (k, 2): rows of the source's and the target's feature points */
  EMTR_TIM_SOURCE = 9,      /* float32 (l, 3): p_k - p_j of the TIMs that are not pruned */
  EMTR_TIM_TARGET = 10,
  EMTR_SOURCE_FEATURE_POINTS = 11, /* float32 (n, 3): the points that are matched: the dense cloud,
                                      or those with user-provided features or correspondences */
  EMTR_TARGET_FEATURE_POINTS = 12,
  EMTR_SOURCE_FEATURE_ROWS = 13, /* int32 (n, 1): their rows in the user's cloud; no rows when they
                                    are the dense cloud */
  EMTR_TARGET_FEATURE_ROWS = 14
} emtr_array;

/* Gives a view of one of the problem's arrays, row-major, valid until the problem is freed.
 * Errors: EMTR_ERROR_ARGUMENT for an unknown array. */
EMTR_API emtr_status emtr_problem_array(const emtr_problem* problem, emtr_array which,
                                        const void** data, size_t* rows, size_t* columns);

#ifdef __cplusplus
}
#endif

#endif /* EMTR_EMTR_H */
