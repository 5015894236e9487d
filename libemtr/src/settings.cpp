#include "settings.h"

#include <omp.h>

#include <cmath>
#include <cstring>
#include <sstream>
#include <utility>
#include <vector>

#include "error.h"
#include "rigid.h"

namespace emtr {
namespace {

constexpr auto Integer = EMTR_SETTING_INTEGER;
constexpr auto Real = EMTR_SETTING_REAL;
constexpr auto Switch = EMTR_SETTING_SWITCH;
constexpr auto Choice = EMTR_SETTING_CHOICE;
constexpr double kExactInteger = 9007199254740992.0;  // 2^53

constexpr Setting::Storage storage_of(const std::int32_t*) { return Setting::Storage::Int32; }
constexpr Setting::Storage storage_of(const std::uint64_t*) { return Setting::Storage::Uint64; }
constexpr Setting::Storage storage_of(const double*) { return Setting::Storage::Double; }

#define SETTING(field, type, unit, minimum, maximum, value, part, text, choices)                   \
  {                                                                                                \
    {#field, type, unit, minimum, maximum, value, part, text, choices}, offsetof(Settings, field), \
        storage_of(static_cast<decltype(Settings::field)*>(nullptr))                               \
  }

// The one place where a setting's unit, range, default and meaning stand. The values that the
// paper gives are its own; the others were settled by measurement.
const std::vector<Setting>& table() {
  static const std::vector<Setting> rows = {
      SETTING(seed, Integer, "", 0, kExactInteger, 0, "", "seed of all random numbers", ""),
      SETTING(threads, Integer, "threads", 0, 1024, 0, "",
              "threads to use, 0 for as many as OpenMP would; the result does not depend on it",
              ""),
      SETTING(dense_points, Integer, "points", 100, 1e6, 9000, "sparse to dense",
              "points of both dense clouds together", ""),
      SETTING(sparse_points, Integer, "points", 10, 1e6, 600, "sparse to dense",
              "points of the sparse source cloud", ""),
      SETTING(minimum_leaf_spacing, Real, "point spacings", 0, 100, 1.5, "sparse to dense",
              "least dense leaf", ""),
      SETTING(normal_radius, Real, "dense leaves", 1, 50, 2, "features and matches",
              "radius of the normals' neighbourhoods", ""),
      SETTING(feature_radius, Real, "dense leaves", 1, 50, 5, "features and matches",
              "radius of the FPFH neighbourhoods", ""),
      SETTING(max_correspondences, Integer, "matches", 3, 20000, 1000, "features and matches",
              "most matches kept, those with the nearest descriptors", ""),
      SETTING(max_tims, Integer, "pairs", 3, 1e8, 5000, "features and matches",
              "most pairs of correspondences made into TIMs", ""),
      SETTING(
          features, Choice, "", 0, 1, 1, "features and matches",
          "who computes normals and FPFH: PCL's own functions, or the same definition vectorised",
          "pcl,simd"),
      SETTING(seeds, Integer, "poses", 0, 10000, 200, "seeds",
              "most poses made of spatially consistent matches", ""),
      SETTING(seed_threshold, Real, "dense leaves", 0.1, 100, 1.5, "seeds",
              "how far consistent matches may disagree", ""),
      SETTING(injected_seeds, Integer, "particles", 0, 100000, 10, "seeds",
              "particles of both swarms that start at a seed", ""),
      SETTING(tau_factor, Real, "resolutions", 1e-3, 100, 0.5, "task beta",
              "tau over the mean resolution of the feature clouds", ""),
      SETTING(inlier_threshold, Real, "tau", 1e-3, 1e3, 5, "task beta",
              "largest residual of a TIM inlier", ""),
      SETTING(outlier_penalty, Real, "tau", 1e-3, 1e6, 50, "task beta",
              "eta, what each TIM outlier costs", ""),
      SETTING(scale_sparse, Real, "sparse leaves", 0.1, 10, 1.5, "task alpha",
              "scale c of the M-estimator in the sparse stage", ""),
      SETTING(scale_dense, Real, "dense leaves", 0.1, 10, 1.2, "task alpha",
              "scale c of the M-estimator in the dense stage", ""),
      SETTING(translation_bound, Real, "radii", 1e-3, 4, 1.2, "task alpha",
              "half the side of the box searched for translations", ""),
      SETTING(population, Integer, "particles", 2, 100000, 50, "particle swarm",
              "particles of each of the two tasks", ""),
      SETTING(iterations, Integer, "iterations", 1, 1000000, 25, "particle swarm",
              "generations of the evolution (MaxIt)", ""),
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
      SETTING(transfer, Switch, "", 0, 1, 1, "knowledge transfer",
              "knowledge transfer between the tasks", ""),
      SETTING(transfer_probability, Real, "", 0, 1, 0.7, "knowledge transfer",
              "chance of a transfer in an iteration (rmp)", ""),
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
      SETTING(neighbors, Choice, "", 0, 2, 0, "", "structure behind the look-ups; same results",
              "grid,kdtree,brute"),
      SETTING(candidates, Integer, "poses", 0, 10000, 12, "candidates",
              "poses polished and ranked; 0: the swarm's best is the answer", ""),
      SETTING(free_space, Switch, "", 0, 1, 1, "candidates",
              "points in front of what the other scan saw count against a pose", ""),
      SETTING(escalation, Choice, "", 0, 2, 1, "escalation",
              "search again with more feature points and both signs of the normals",
              "off,auto,always"),
      SETTING(escalation_confidence, Real, "", 0, 1, 0.9, "escalation",
              "escalate below this confidence", ""),
      SETTING(escalation_points, Integer, "points", 100, 1e6, 32000, "escalation",
              "points of both feature clouds together", ""),
      SETTING(escalation_correspondences, Integer, "matches", 3, 20000, 5000, "escalation",
              "most matches kept, those with the nearest descriptors", ""),
      SETTING(escalation_seeds, Integer, "poses", 1, 10000, 600, "escalation",
              "most poses made of spatially consistent matches", ""),
      SETTING(escalation_candidates, Integer, "poses", 1, 10000, 100, "escalation",
              "poses polished and ranked", ""),
      SETTING(refine, Switch, "", 0, 1, 1, "refinement", "polish the answer on fine clouds", ""),
      SETTING(refine_leaf, Real, "radii", 1e-3, 0.5, 0.015, "refinement", "leaf of the fine clouds",
              ""),
      SETTING(maximum_fitness, Real, "", 0, 1, 0.7, "verdict",
              "registered only when the mean of rho over both dense clouds is at most this", ""),
      SETTING(minimum_mode_gap, Real, "", 0, 1, 0.05, "verdict",
              "registered only when the next best other pose is worse by this", ""),
      SETTING(minimum_confidence, Real, "", 0, 1, 0.5, "verdict",
              "registered only when the confidence is at least this", ""),
  };
  return rows;
}

#undef SETTING

struct Preset {
  const char* name;
  std::vector<std::pair<const char*, double>> changes;  ///< against the table
};

const std::vector<Preset>& presets() {
  static const std::vector<Preset> all = {
      {"default", {}},
      {"fast",
       {{"dense_points", 6000},
        {"iterations", 12},
        {"population", 30},
        {"candidates", 12},
        {"escalation", 0}}},
      {"thorough", {{"escalation", 2}}},
      // The method as published: the swarm alone, no seeds before it and no polish after it.
      {"paper",
       {{"dense_points", 4000},
        {"features", 0},
        {"max_tims", 100000},
        {"seeds", 0},
        {"injected_seeds", 0},
        {"translation_bound", 0.5},
        {"iterations", 100},
        {"candidates", 0},
        {"free_space", 0},
        {"escalation", 0},
        {"refine", 0}}},
  };
  return all;
}

void store(Settings& settings, const Setting& row, double value) {
  char* field = reinterpret_cast<char*>(&settings) + row.offset;
  switch (row.storage) {
    case Setting::Storage::Int32: {
      const auto v = static_cast<std::int32_t>(value);
      std::memcpy(field, &v, sizeof v);
      break;
    }
    case Setting::Storage::Uint64: {
      const auto v = static_cast<std::uint64_t>(value);
      std::memcpy(field, &v, sizeof v);
      break;
    }
    case Setting::Storage::Double:
      std::memcpy(field, &value, sizeof value);
      break;
  }
}

void check_range(const emtr_setting_info& info, double value) {
  const bool whole = info.type == Real || value == std::floor(value);
  if (value >= info.minimum && value <= info.maximum && whole) return;  // false for NaN
  std::ostringstream message;
  message.precision(17);
  message << "setting '" << info.name << "' is " << value << ", expected ";
  if (info.type == Switch)
    message << "0 or 1";
  else
    message << (info.type == Real ? "a number" : "a whole number") << " from " << info.minimum
            << " to " << info.maximum;
  throw Error(EMTR_ERROR_SETTING, message.str());
}

void require(bool holds, const char* message) {
  if (!holds) throw Error(EMTR_ERROR_SETTING, message);
}

}  // namespace

std::size_t setting_count() { return table().size(); }

const Setting& setting(std::size_t index) { return table().at(index); }

const Setting& find_setting(const std::string& name) {
  for (const Setting& row : table())
    if (name == row.info.name) return row;
  throw Error(EMTR_ERROR_SETTING, "there is no setting '" + name + "'");
}

void set(Settings& settings, const std::string& name, double value) {
  const Setting& row = find_setting(name);
  check_range(row.info, value);
  store(settings, row, value);
}

double get(const Settings& settings, const Setting& row) {
  const char* field = reinterpret_cast<const char*>(&settings) + row.offset;
  if (row.storage == Setting::Storage::Int32) {
    std::int32_t v;
    std::memcpy(&v, field, sizeof v);
    return v;
  }
  if (row.storage == Setting::Storage::Uint64) {
    std::uint64_t v;
    std::memcpy(&v, field, sizeof v);
    return static_cast<double>(v);
  }
  double v;
  std::memcpy(&v, field, sizeof v);
  return v;
}

const char* preset_name(std::size_t index) {
  return index < presets().size() ? presets()[index].name : nullptr;
}

Settings preset(const std::string& name) {
  std::string names;
  for (const Preset& preset : presets()) {
    if (name == preset.name) {
      Settings settings{};
      settings.size = sizeof settings;
      for (const Setting& row : table()) store(settings, row, row.info.value);
      for (const auto& [setting, value] : preset.changes) set(settings, setting, value);
      return settings;
    }
    names += (names.empty() ? "" : ", ") + std::string(preset.name);
  }
  throw Error(EMTR_ERROR_SETTING, "there is no preset '" + name + "', expected one of " + names);
}

void validate(const Settings& settings) {
  for (const Setting& row : table())
    if (row.storage != Setting::Storage::Uint64) check_range(row.info, get(settings, row));
  require(settings.sparse_points < settings.dense_points,
          "settings 'sparse_points' and 'dense_points' contradict each other: the sparse source "
          "cloud must have fewer points than both dense clouds together");
  require(settings.normal_radius <= settings.feature_radius,
          "settings 'normal_radius' and 'feature_radius' contradict each other: a feature's "
          "neighbourhood must not be smaller than a normal's");
  require(settings.complement_scale_end <= settings.complement_scale_start,
          "settings 'complement_scale_end' and 'complement_scale_start' contradict each other: "
          "the scale must not grow");
  require(!settings.has_guess || is_rigid(settings.guess),
          "setting 'guess' is not a rigid transformation: expected a row-major 4x4 of a rotation, "
          "a translation and (0, 0, 0, 1)");
}

int thread_count(const Settings& settings) {
  return settings.threads > 0 ? settings.threads : omp_get_max_threads();
}

}  // namespace emtr
