#include "pipeline/result_table.h"

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace emtr {
namespace {

constexpr auto Real = EMTR_FIELD_REAL;
constexpr auto Integer = EMTR_FIELD_INT32;
constexpr auto Switch = EMTR_FIELD_SWITCH;
constexpr auto Size = EMTR_FIELD_SIZE;
constexpr auto Unsigned = EMTR_FIELD_UINT64;
constexpr auto Text = EMTR_FIELD_TEXT;
constexpr auto Reason = EMTR_FIELD_REASON;
constexpr auto Alternative = EMTR_FIELD_ALTERNATIVE;

template <emtr_field_type>
struct Stored;
template <>
struct Stored<Real> : std::common_type<double> {};
template <>
struct Stored<Integer> : std::common_type<std::int32_t> {};
template <>
struct Stored<Switch> : std::common_type<std::int32_t> {};
template <>
struct Stored<Size> : std::common_type<std::size_t> {};
template <>
struct Stored<Unsigned> : std::common_type<std::uint64_t> {};
template <>
struct Stored<Text> : std::common_type<const char*> {};
template <>
struct Stored<Reason> : std::common_type<emtr_reason> {};
template <>
struct Stored<Alternative> : std::common_type<emtr_alternative> {};

/// Returns how many columns a field of this type has when it is made of so many rows. Fails to
/// compile when the field stores something else than the table says.
template <class Field, emtr_field_type Type, std::size_t Rows>
constexpr std::size_t columns() {
  using Element = typename Stored<Type>::type;
  if constexpr (std::is_same_v<Field, const Element*>) {
    static_assert(Rows == 1, "a field of variable length is one row");
    return 0;
  } else {
    static_assert(std::is_same_v<std::remove_extent_t<Field>, Element>, "another type of field");
    constexpr std::size_t count = std::is_array_v<Field> ? std::extent_v<Field> : 1;
    static_assert(count % Rows == 0, "rows of different lengths");
    return count / Rows;
  }
}

#define ROW(field, type, rows, count, group, key, unit, text)                    \
  {                                                                              \
#field, group, key, type, offsetof(emtr_result, field), rows,                \
        columns < decltype(emtr_result::field), type, rows>(), count, unit, text \
  }
#define FIELD(field, type, group, unit, text) ROW(field, type, 1, 0, group, #field, unit, text)
#define MATRIX(field, rows, group, unit, text) ROW(field, Real, rows, 0, group, #field, unit, text)
#define QUERIES(key, text) ROW(queries_##key, Unsigned, 1, 0, "queries", #key, "queries", text)
#define SECONDS(key, text) ROW(seconds_##key, Real, 1, 0, "seconds", #key, "seconds", text)
#define HISTORY(key, text) \
  ROW(history_##key, Real, 1, offsetof(emtr_result, iterations), "history", #key, "", text)

}  // namespace

// The one place where a field's type, shape, group, unit and meaning are declared.
const std::vector<emtr_result_field_info>& result_table() {
  static const std::vector<emtr_result_field_info> rows = {
    FIELD(seed, Unsigned, "", "", "seed of all random numbers, as it was set"),
    FIELD(threads, Integer, "", "threads", "threads asked for; OpenMP may have given fewer"),
    FIELD(kernel, Text, "", "", "instruction set of the inner loops"),

    FIELD(registered, Switch, "", "", "whether the pose is held to be right"),
    FIELD(reason, Reason, "", "", "why the pose is held to be right, or why not"),
    FIELD(confidence, Real, "", "",
          "estimated probability that the pose is right, within 5 degrees and 0.06 radii; NaN "
          "without candidates and when stopped before all of them were ranked"),
    MATRIX(transformation, 4, "", "user's unit",
           "source into target; all NaN when stopped before any pose was known"),

    FIELD(fitness, Real, "quality", "", "mean of rho over both dense clouds, 0 (best) to 1"),
    FIELD(inlier_ratio_source, Real, "quality", "",
          "share of the dense source points within c of the target"),
    FIELD(inlier_ratio_target, Real, "quality", "",
          "share of the dense target points within c of the source"),
    FIELD(fitness_gap, Real, "quality", "",
          "fitness of the best clearly different pose minus that of this one"),
    FIELD(overlap_source, Real, "quality", "",
          "share of the source's points with a correspondence on the target's fine cloud, within "
          "leaf_fine; NaN when interrupted"),
    FIELD(overlap_target, Real, "quality", "",
          "share of the target's points with a correspondence on the source's fine cloud"),
    FIELD(inlier_rmse, Real, "quality", "user's unit",
          "root mean square distance of these source points to their correspondences"),
    FIELD(inlier_rmse_plane, Real, "quality", "user's unit",
          "root mean square distance to the tangent planes there, which does not grow with the "
          "spacing of the points"),
    FIELD(
        score, Real, "quality", "",
        "surface_fit - 0.1 (surface_near - surface_fit) - violation, at most 1; the share of given "
        "matches that are inliers where these decide"),
    FIELD(surface_fit, Real, "quality", "",
          "how well the surfaces lie on each other, each point by its distinctiveness, 0 to 1 "
          "(best)"),
    FIELD(surface_near, Real, "quality", "",
          "share of the points near the other surface, on it or not, by distinctiveness"),
    FIELD(violation, Real, "quality", "",
          "share of the points in front of what the other scan saw, 0 (best) to 1, times the trust "
          "in the place of its sensor"),
    FIELD(evidence, Real, "quality", "points",
          "how many dense points of the poorer cloud lie on the other"),
    FIELD(scale_factor, Real, "quality", "",
          "factor of the source's lengths at which it fits better; 1 where none does"),
    FIELD(score_gap, Real, "quality", "",
          "score minus that of the best clearly different candidate"),

    FIELD(used_fallback_search, Switch, "", "",
          "whether a second search was made, with more feature points"),
    FIELD(refined, Switch, "", "", "whether the pose was refined on the fine clouds"),
    ROW(alternatives, Alternative, 1, offsetof(emtr_result, alternative_count), "", "alternatives",
        "", "clearly different poses, best first, at most 10"),

    FIELD(symmetry, Text, "symmetry", "",
          "motion after which the clouds fit about as well: none, rotational, continuous, "
          "translational; unknown without candidates"),
    FIELD(symmetry_order, Integer, "symmetry", "",
          "n of rotations by 360 / n degrees about the axis; 0 unless rotational"),
    FIELD(symmetry_axis, Real, "symmetry", "",
          "axis of the rotations or direction of the translations, in the target's axes, unit "
          "length; NaN where there is no symmetry"),
    FIELD(symmetry_period, Real, "symmetry", "user's unit",
          "length of the shortest translation; 0 where any is one, NaN unless translational"),

    FIELD(scale, Real, "", "",
          "factor of the source's lengths, by which the rotation is multiplied in the "
          "transformation; 1 unless searched"),
    FIELD(scale_constraint, Real, "refinement", "",
          "how strongly the surfaces constrain the scale, 0 (not at all) to about 1; NaN unless "
          "searched"),
    MATRIX(information_similarity, 7, "refinement", "",
           "inverse covariance of a similarity: a small rotation, a translation, and the "
           "logarithm of the scale, about center_target; NaN unless searched"),
    FIELD(used_colors, Switch, "colors", "",
          "1: colors decided about the pose, or took part in its refinement"),
    FIELD(
        color_correlation, Real, "colors", "",
        "correlation of the colors of both clouds where they overlap, -1 to 1; NaN where they were "
        "not looked at, or tell nothing"),
    FIELD(
        color_evidence, Real, "colors", "",
        "logarithm of the likelihood of these colors under the pose by that of unrelated ones; NaN "
        "as above"),

    MATRIX(information, 6, "refinement", "",
           "inverse covariance of a small rotation (radians) and then a translation (user's "
           "unit) about center_target; NaN when not refined"),
    FIELD(hessian_eigenvalues, Real, "refinement", "",
          "eigenvalues of the Hessian, ascending, 0 for an unconstrained motion to about 1; NaN "
          "when not refined"),
    MATRIX(hessian_eigenvectors, 6, "refinement", "",
           "the eigenvectors, one a row, of unit length: rotation at the surfaces' radius, then "
           "translation; "
           "NaN when not refined"),
    FIELD(unconstrained_directions, Integer, "refinement", "",
          "how many directions the surfaces leave unconstrained; -1 when not refined"),

    FIELD(points_source, Size, "counts", "points", "finite points of the source"),
    FIELD(points_target, Size, "counts", "points", "finite points of the target"),
    FIELD(dropped_source, Size, "counts", "points",
          "points of the source with a NaN or an infinity"),
    FIELD(dropped_target, Size, "counts", "points",
          "points of the target with a NaN or an infinity"),
    FIELD(strays_source, Size, "counts", "points",
          "finite points of the source far outside of all the others or scattered off the surface, "
          "which were left out"),
    FIELD(strays_target, Size, "counts", "points",
          "finite points of the target far outside of all the others or scattered off the surface, "
          "which were left out"),
    FIELD(sparse_source, Size, "counts", "points", "points of the sparse source cloud"),
    FIELD(sparse_target, Size, "counts", "points", "points of the sparse target cloud"),
    FIELD(dense_source, Size, "counts", "points", "points of the dense source cloud"),
    FIELD(dense_target, Size, "counts", "points", "points of the dense target cloud"),
    FIELD(correspondences, Size, "counts", "matches",
          "feature matches kept, max_correspondences at most"),
    FIELD(correspondences_found, Size, "counts", "matches", "feature matches found"),
    FIELD(tims, Size, "counts", "pairs", "pairs of matches made into TIMs, max_tims at most"),
    FIELD(tims_pruned, Size, "counts", "pairs",
          "TIMs among them that are an inlier of no rotation and need no work"),
    FIELD(seeds, Size, "counts", "poses", "poses that consistent matches gave"),
    FIELD(candidates, Size, "counts", "poses", "distinct poses ranked"),
    FIELD(iterations, Size, "counts", "iterations", "iterations of the evolution that were done"),

    QUERIES(evaluation, "nearest-neighbor queries of the particles, the paper's cost"),
    QUERIES(switch, "queries of the pbests, evaluated again at the switch from sparse to dense"),
    QUERIES(complement, "queries of the knowledge complement (Algorithm 2)"),

    FIELD(normalization_scale, Real, "normalization", "user's unit",
          "the normalized frame is p' = (p - center) / normalization_scale"),
    FIELD(center_source, Real, "normalization", "user's unit", "centroid of the source"),
    FIELD(center_target, Real, "normalization", "user's unit", "centroid of the target"),
    FIELD(leaf_sparse, Real, "normalization", "radii", "leaf of the sparse clouds"),
    FIELD(leaf_dense, Real, "normalization", "radii", "leaf of the dense clouds"),
    FIELD(leaf_fine, Real, "normalization", "radii",
          "leaf of the fine clouds; NaN when interrupted"),

    SECONDS(normalization, "reading, measuring and normalizing both clouds"),
    SECONDS(scale_search, "looking for the scale of the source"),
    SECONDS(downsampling, "the sparse and the dense clouds"),
    SECONDS(features, "normals and descriptors"),
    SECONDS(matching, "correspondences, TIMs and both tasks"),
    SECONDS(seeds, "poses of consistent matches; 0 when not run, as for all stages"),
    SECONDS(evolution, "both swarms"),
    SECONDS(candidates, "refining and ranking the candidates"),
    SECONDS(fallback_search, "the second search"),
    SECONDS(refinement, "refining the answer on the fine clouds"),
    SECONDS(verdict, "overlap, confidence and reason"),
    SECONDS(total, "all stages"),

    HISTORY(alpha,
            "best fitness of task alpha after each iteration; its scale changes at the switch"),
    HISTORY(beta, "best fitness of task beta after each iteration"),
  };
  return rows;
}

}  // namespace emtr
