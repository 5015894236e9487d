#include "settings/settings_table.h"

namespace emtr {
namespace {

constexpr auto Integer = EMTR_SETTING_INTEGER;
constexpr auto Real = EMTR_SETTING_REAL;
constexpr auto Switch = EMTR_SETTING_SWITCH;
constexpr auto Choice = EMTR_SETTING_CHOICE;
constexpr const char* kWhen = "off,auto,always";      // by value of When
constexpr double kExactInteger = 9007199254740992.0;  // 2^53

constexpr Setting::Storage storage_of(const std::int32_t*) { return Setting::Storage::Int32; }
constexpr Setting::Storage storage_of(const std::uint64_t*) { return Setting::Storage::Uint64; }
constexpr Setting::Storage storage_of(const double*) { return Setting::Storage::Double; }

#define SETTING(field, type, unit, minimum, maximum, value, part, text, choices)                   \
  {                                                                                                \
    {#field, type, unit, minimum, maximum, value, part, text, choices}, offsetof(Settings, field), \
        storage_of(static_cast<decltype(Settings::field)*>(nullptr))                               \
  }

}  // namespace

// The one place where a setting's unit, range, default and meaning are declared. Values that the
// paper gives are the paper's; the others were settled by measurement.
const std::vector<Setting>& setting_table() {
  static const std::vector<Setting> rows = {
      SETTING(seed, Integer, "", 0, kExactInteger, 0, "", "seed of all random numbers", ""),
      SETTING(threads, Integer, "threads", 0, kMaxThreads, 0, "",
              "threads to use, 0 for as many as OpenMP would; the result does not depend on it",
              ""),
      SETTING(time_limit, Real, "seconds", 0, 1e9, 0, "",
              "give the best pose so far after this time, 0 for no limit", ""),
      SETTING(dense_points, Integer, "points", kFewestPoints, 1e6, 9000, "sparse to dense",
              "points of both dense clouds together", ""),
      SETTING(coarse_points, Integer, "points", 0, 1e6, 2500, "sparse to dense",
              "points of both dense clouds together in a first, coarse search: a pose that leaves "
              "no doubt is the answer; 0, or not below dense_points: no such search",
              ""),
      SETTING(sparse_points, Integer, "points", 10, 1e6, 600, "sparse to dense",
              "points of the sparse source cloud", ""),
      SETTING(minimum_leaf_spacing, Real, "point spacings", 0, 100, 1.5, "sparse to dense",
              "least dense leaf", ""),
      SETTING(
          maximum_leaf_growth, Real, "", 1, 100, 4, "sparse to dense",
          "how many times the dense leaf may grow where a cloud lies along curves, as the rings "
          "of a spinning LiDAR do, until it lies like a surface; 1: not at all",
          ""),
      SETTING(leaf_ladder, Switch, "", 0, 1, 1, "sparse to dense",
              "round leaves, and the scale of the normalized frame, to eight lengths an octave, so "
              "that what is made of a preprocessed cloud serves beside the next",
              ""),
      SETTING(normal_radius, Real, "dense leaves", 1, 50, 2, "features and matches",
              "radius of the normals' neighborhoods", ""),
      SETTING(feature_radius, Real, "dense leaves", 1, 50, 5, "features and matches",
              "radius of the FPFH neighborhoods", ""),
      SETTING(max_correspondences, Integer, "matches", 3, 20000, 1000, "features and matches",
              "most matches kept, those with the nearest descriptors", ""),
      SETTING(max_tims, Integer, "pairs", 3, 1e8, 5000, "features and matches",
              "most pairs of correspondences made into TIMs", ""),
      SETTING(
          features, Choice, "", EMTR_FEATURES_PCL, EMTR_FEATURES_SIMD, EMTR_FEATURES_SIMD,
          "features and matches",
          "who computes normals and FPFH: PCL's own functions, or the same definition vectorised",
          "pcl,simd"),
      SETTING(seeds, Integer, "poses", 0, 10000, 200, "seeds",
              "most poses made of spatially consistent matches", ""),
      SETTING(seed_threshold, Real, "dense leaves", 0.1, 100, 1.5, "seeds",
              "how far consistent matches may disagree", ""),
      SETTING(injected_seeds, Integer, "particles", 0, 100000, 10, "seeds",
              "particles of both swarms that start at a seed", ""),
      SETTING(tau_factor, Real, "resolutions", 1e-3, 100, 0.5, "task beta",
              "tau over the mean resolution of the dense clouds", ""),
      SETTING(inlier_threshold, Real, "tau", 1e-3, 1e3, 5, "task beta",
              "largest residual of a TIM inlier", ""),
      SETTING(outlier_penalty, Real, "tau", 1e-3, 1e6, 50, "task beta",
              "eta, what each TIM outlier costs", ""),
      SETTING(scale_sparse, Real, "sparse leaves", 0.1, 10, 1.5, "task alpha",
              "scale c of the M-estimator in the sparse stage", ""),
      SETTING(scale_dense, Real, "dense leaves", 0.1, 10, 1.2, "task alpha",
              "scale c of the M-estimator in the dense stage", ""),
      SETTING(dense_reference, Choice, "", EMTR_REFERENCE_DENSE, EMTR_REFERENCE_WHOLE,
              EMTR_REFERENCE_DENSE, "task alpha",
              "points in which the dense stage looks for neighbors: those of the dense clouds, or "
              "of the whole clouds, and then c is at least two of their spacings",
              "dense,whole"),
      SETTING(translation_bound, Real, "radii", 1e-3, 4, 1.2, "task alpha",
              "half the side of the box searched for translations", ""),
      SETTING(population, Integer, "particles", 2, 100000, 50, "particle swarm",
              "particles of each of the two tasks", ""),
      SETTING(iterations, Integer, "iterations", 1, 1000000, 25, "particle swarm",
              "generations of the evolution (MaxIt)", ""),
      SETTING(stall_iterations, Integer, "iterations", 0, 1000000, 4, "particle swarm",
              "with seeds and candidates: end once the best pose has stayed in one place for so "
              "many; 0: never before all are done",
              ""),
      SETTING(inertia_start, Real, "", 0, 2, 0.9, "particle swarm", "inertia weight w at the start",
              ""),
      SETTING(inertia_end, Real, "", 0, 2, 0.4, "particle swarm", "inertia weight w at the end",
              ""),
      SETTING(cognitive, Real, "", 0, 10, 1.49445, "particle swarm",
              "pull to the particle's best (c1)", ""),
      SETTING(social, Real, "", 0, 10, 1.49445, "particle swarm", "pull to the swarm's best (c2)",
              ""),
      SETTING(velocity_limit, Real, "ranges", 1e-3, 1, 0.5, "particle swarm",
              "largest step of a gene in one iteration", ""),
      SETTING(
          rotation_vector_steps, Choice, "", EMTR_OFF, EMTR_ALWAYS, EMTR_AUTO, "particle swarm",
          "step by rotation vectors instead of Euler angles; auto: where no particle starts at a "
          "seed",
          kWhen),
      SETTING(transfer, Switch, "", 0, 1, 1, "knowledge transfer",
              "knowledge transfer between the tasks", ""),
      SETTING(transfer_probability, Real, "", 0, 1, 0.7, "knowledge transfer",
              "chance of a transfer in an iteration (rmp)", ""),
      SETTING(arc_transfer, Choice, "", EMTR_OFF, EMTR_ALWAYS, EMTR_AUTO, "knowledge transfer",
              "mix rotations along the shortest arc instead of angle by angle; auto: where no "
              "particle starts at a seed",
              kWhen),
      SETTING(lambda_alpha_start, Real, "", 0, 1, 0.1, "knowledge transfer",
              "alpha's own share in its guide, at the start", ""),
      SETTING(lambda_alpha_end, Real, "", 0, 1, 0.7, "knowledge transfer",
              "alpha's own share in its guide, at the end", ""),
      SETTING(lambda_beta_start, Real, "", 0, 1, 0.999, "knowledge transfer",
              "beta's own share in its guide, at the start", ""),
      SETTING(lambda_beta_end, Real, "", 0, 1, 0.199, "knowledge transfer",
              "beta's own share in its guide, at the end", ""),
      SETTING(complement, Switch, "", 0, 1, 1, "knowledge complement",
              "complete beta's rotation with a translation (Algorithm 2)", ""),
      SETTING(complement_iterations, Integer, "iterations", 1, 10000, 20, "knowledge complement",
              "iterations of Algorithm 2 (MaxIt_KC)", ""),
      SETTING(complement_scale_start, Real, "radii", 1e-3, 4, 0.5, "knowledge complement",
              "Tukey scale d of Algorithm 2 at its start", ""),
      SETTING(complement_scale_end, Real, "radii", 1e-3, 4, 0.08, "knowledge complement",
              "Tukey scale d of Algorithm 2 at its end", ""),
      SETTING(sparse_to_dense, Switch, "", 0, 1, 1, "sparse to dense",
              "begin on the sparse clouds; off: dense throughout", ""),
      SETTING(switch_fraction, Real, "", 0, 1, 0.6, "sparse to dense",
              "share of the iterations done on the sparse clouds (delta)", ""),
      SETTING(neighbors, Choice, "", EMTR_NEIGHBORS_GRID, EMTR_NEIGHBORS_BRUTE_FORCE,
              EMTR_NEIGHBORS_GRID, "", "structure of the nearest-neighbor queries; same results",
              "grid,kdtree,brute"),
      SETTING(candidates, Integer, "poses", 0, 10000, 12, "candidates",
              "poses refined and ranked; 0: the swarm's best is the answer", ""),
      SETTING(free_space, Switch, "", 0, 1, 1, "candidates",
              "points in front of what the other scan saw count against a pose", ""),
      SETTING(distinctiveness, Switch, "", 0, 1, 1, "candidates",
              "what faces as little else of its cloud counts most in the score", ""),
      SETTING(rivals, Switch, "", 0, 1, 1, "candidates",
              "rank what a symmetric scene would fit as well as the best pose", ""),
      SETTING(fallback_search, Choice, "", EMTR_OFF, EMTR_ALWAYS, EMTR_AUTO, "fallback search",
              "search again with more feature points and both signs of the normals", kWhen),
      SETTING(fallback_confidence, Real, "", 0, 1, 0.97, "fallback search",
              "with auto: search again below this confidence", ""),
      SETTING(fallback_points, Integer, "points", 100, 1e6, 24000, "fallback search",
              "points of both feature clouds together", ""),
      SETTING(fallback_correspondences, Integer, "matches", 3, 20000, 5000, "fallback search",
              "most matches kept, those that stand out most among their nearest ten", ""),
      SETTING(fallback_seeds, Integer, "poses", 1, 10000, 600, "fallback search",
              "most poses made of spatially consistent matches", ""),
      SETTING(fallback_candidates, Integer, "poses", 1, 10000, 200, "fallback search",
              "poses refined and ranked", ""),
      SETTING(plane_aligned_poses, Integer, "poses", 0, 1000, 48, "fallback search",
              "most poses that lay one dominant plane on the other; 0: none", ""),
      SETTING(parts, Integer, "parts", 0, 100, 6, "fallback search",
              "parts of the larger cloud in which a much smaller one is looked for; 0: none", ""),
      SETTING(refine, Switch, "", 0, 1, 1, "refinement", "refine the answer on fine clouds", ""),
      SETTING(refine_leaf, Real, "radii", 1e-3, 0.5, 0.01, "refinement", "leaf of the fine clouds",
              ""),
      SETTING(scale, Choice, "", EMTR_SCALE_FIXED, EMTR_SCALE_UNITS, EMTR_SCALE_FIXED,
              "unknown scale",
              "scales of the source that are searched: fixed: none; free: any; bounded: from "
              "scale_minimum to scale_maximum; units: factors between units of length; one number "
              "or two "
              "stand for bounded",
              "fixed,free,bounded,units"),
      SETTING(scale_minimum, Real, "", 1e-6, 1e6, 1, "unknown scale",
              "least factor of the source's lengths", ""),
      SETTING(scale_maximum, Real, "", 1e-6, 1e6, 1, "unknown scale",
              "largest factor of the source's lengths", ""),
      SETTING(task_gamma, Switch, "", 0, 1, 1, "unknown scale",
              "look first at the scales for which pairs of matches vote", ""),
      SETTING(
          use_colors, Choice, "", EMTR_OFF, EMTR_ALWAYS, EMTR_AUTO, "colors",
          "use the colors or intensities of both clouds, auto: where their shape leaves the pose "
          "open; they count only as far as they tell something",
          "off,auto,on"),
      SETTING(maximum_fitness, Real, "", 0, 1, 0.7, "verdict",
              "without candidates: registered only when the mean of rho over both dense clouds is "
              "at most this",
              ""),
      SETTING(minimum_fitness_gap, Real, "", 0, 1, 0.05, "verdict",
              "without candidates: registered only when the next best other pose is worse by this",
              ""),
      SETTING(minimum_confidence, Real, "", 0, 1, 0.5, "verdict",
              "with candidates: registered only when the confidence is at least this", ""),
      SETTING(guess_rotation, Real, "degrees", 0, kAnyRotation, kAnyRotation, "priors",
              "how far the rotation may be from the guess's; 180: any", ""),
      SETTING(guess_translation, Real, "user's unit", 0, kAnyTranslation, kAnyTranslation, "priors",
              "how far the source's centroid may end from where the guess puts it; 1e12: anywhere",
              ""),
      SETTING(axis_tilt, Real, "degrees", 0, 90, 0, "priors",
              "how far the rotated axis may lean from itself", ""),
      SETTING(axis_angle_minimum, Real, "degrees", -360, 360, -180, "priors",
              "least angle about the axis", ""),
      SETTING(axis_angle_maximum, Real, "degrees", -360, 360, 180, "priors",
              "largest angle about the axis; 360 more than the minimum: any", ""),
      SETTING(maximum_rotation, Real, "degrees", 0, kAnyRotation, kAnyRotation, "priors",
              "largest angle of the whole rotation; 180: any", ""),
  };
  return rows;
}

#undef SETTING

const std::vector<Preset>& preset_table() {
  static const std::vector<Preset> all = {
      {"default", {}},
      {"fast",
       {{"dense_points", 5000},
        {"coarse_points", 2000},
        {"iterations", 6},
        {"population", 20},
        {"injected_seeds", 6},
        {"candidates", 6},
        {"fallback_points", 16000},
        {"fallback_seeds", 300},
        {"fallback_candidates", 100},
        {"refine_leaf", 0.015}}},
      {"thorough", {{"fallback_search", EMTR_ALWAYS}}},
      // The method as published: the swarm alone, no seeds before it and no refinement after it.
      // Its refine_leaf is for the overlap and the rmse, which are taken on the fine clouds too.
      {"paper",
       {{"dense_points", 4000},
        {"coarse_points", 0},
        {"maximum_leaf_growth", 1},
        {"leaf_ladder", 0},
        {"features", EMTR_FEATURES_PCL},
        {"max_tims", 100000},
        {"seeds", 0},
        {"injected_seeds", 0},
        {"scale_dense", 0.5},
        {"dense_reference", EMTR_REFERENCE_WHOLE},
        {"translation_bound", 0.5},
        {"iterations", 100},
        {"rotation_vector_steps", EMTR_OFF},
        {"arc_transfer", EMTR_OFF},
        {"candidates", 0},
        {"free_space", 0},
        {"fallback_search", EMTR_OFF},
        {"refine", 0},
        {"refine_leaf", 0.015},
        {"use_colors", EMTR_OFF},
        {"maximum_fitness", 0.75}}},
  };
  return all;
}

}  // namespace emtr
