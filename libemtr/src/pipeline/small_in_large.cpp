#include "pipeline/small_in_large.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "pipeline/problem.h"
#include "pipeline/rival_results.h"
#include "pipeline/scene_parts.h"
#include "pipeline/solve.h"
#include "settings/choices.h"
#include "util/error.h"
#include "util/held_stage.h"

namespace emtr {
namespace {

constexpr double kDifferent = 1.5, kVeryDifferent = 4;  // times, by the radius

/// Registers the small cloud with one part at a time.
class PartRegistration {
 public:
  PartRegistration(const InputCloud& small, bool small_is_source, CancellationToken& token)
      : small_(small), small_is_source_(small_is_source), token_(token) {}

  /// Returns null where the part has too few points to be registered.
  std::unique_ptr<Result> operator()(const ScenePart& part, const Settings& settings) const {
    const emtr_cloud cloud{part.points.data(), part.points.size() / 3, 0, EMTR_FLOAT64};
    InputCloud small{nullptr, small_.preprocessed}, large{&cloud, nullptr};
    try {
      const auto problem =
          make_problem(small_is_source_ ? small : large, small_is_source_ ? large : small, settings,
                       token_, Stages::Needed);
      const std::vector<Rigid> poses = poses_of(part, *problem);
      return solve(*problem, token_, &poses);
    } catch (const Error& error) {
      if (error.status() != EMTR_ERROR_CLOUD) throw;
      return nullptr;
    }
  }

 private:
  std::vector<Rigid> poses_of(const ScenePart& part, const Problem& problem) const {
    std::vector<Rigid> out;
    for (const Rigid& pose : part.poses)
      out.push_back(
          problem.pair.normalization.to_normalized(small_is_source_ ? pose : pose.inverse()));
    return out;
  }

  const InputCloud& small_;
  const bool small_is_source_;
  CancellationToken& token_;
};

/// Speaks of the whole large cloud instead of its part.
void speak_of_whole(const PreprocessedCloud& large, bool small_is_source, Result& out) {
  const std::size_t points = small_is_source ? out.points_target : out.points_source;
  const double share = static_cast<double>(points) / static_cast<double>(large.count);
  (small_is_source ? out.points_target : out.points_source) = large.count;
  (small_is_source ? out.dropped_target : out.dropped_source) = large.dropped;
  (small_is_source ? out.strays_target : out.strays_source) = large.strays;
  (small_is_source ? out.overlap_target : out.overlap_source) *= share;
  out.used_fallback_search = 1;
}

/// Looks for the small cloud in the part about the user's guess; null without one, or where that
/// does not convince.
std::unique_ptr<Result> register_at_guess(const Scene& scene, const PartRegistration& registered,
                                          bool small_is_source, const Settings& settings) {
  if (!settings.has_guess) return nullptr;
  const Rigid guess = from_matrix(settings.guess);
  auto result = registered(scene.part_at(small_is_source ? guess : guess.inverse()), settings);
  const bool sure =
      result && result->registered && result->confidence >= settings.fallback_confidence;
  return sure ? std::move(result) : nullptr;
}

/// Registers the small cloud with all parts, and takes the others' poses for rivals of the best.
std::unique_ptr<Result> register_in_parts(const std::vector<ScenePart>& parts,
                                          const PartRegistration& registered,
                                          const SmallCloud& small, const Settings& settings) {
  Settings quick = settings;
  quick.fallback_search = EMTR_OFF;
  std::vector<std::unique_ptr<Result>> others;
  std::unique_ptr<Result> best;
  const ScenePart* best_part = nullptr;
  for (const ScenePart& part : parts) {
    auto result = registered(part, quick);
    if (!result || !(result->score == result->score)) continue;  // none, or stopped before one
    if (!best || result->score > best->score) {
      std::swap(best, result);
      best_part = &part;
    }
    if (result) others.push_back(std::move(result));
  }
  if (!best) return nullptr;
  if (!is_stopped(*best) && best->confidence < settings.fallback_confidence) {
    auto again = registered(*best_part, settings);  // finds all that the quick run did, and more
    if (!is_stopped(*again)) best = std::move(again);
  }
  std::vector<const Result*> rivals;
  rivals.reserve(others.size());
  for (const auto& other : others) rivals.push_back(other.get());
  weigh_rivals(rivals, small, settings.minimum_confidence, *best);
  return best;
}

}  // namespace

Sizes compare_sizes(const PreprocessedCloud& source, const PreprocessedCloud& target,
                    const Settings& settings) {
  const bool user_provided = settings.correspondences || source.keypoints || target.keypoints;
  if (user_provided || settings.fallback_search == When::Off || settings.candidates == 0 ||
      settings.seeds == 0 || settings.parts == 0)
    return Sizes::Alike;
  const double ratio =
      std::max(source.radius, target.radius) / std::min(source.radius, target.radius);
  if (ratio < kDifferent) return Sizes::Alike;
  return ratio < kVeryDifferent ? Sizes::Different : Sizes::VeryDifferent;
}

std::unique_ptr<Result> register_small_in_large(const InputCloud& source, const InputCloud& target,
                                                const Settings& settings,
                                                CancellationToken& token) {
  const bool small_is_source = source.preprocessed->radius < target.preprocessed->radius;
  const InputCloud &small = small_is_source ? source : target,
                   &large = small_is_source ? target : source;
  const HeldStage one_stage(token, Stage::FallbackSearch);
  const Scene scene(small, large);
  const PartRegistration registered(small, small_is_source, token);
  auto best = register_at_guess(scene, registered, small_is_source, settings);
  if (!best)
    best = register_in_parts(scene.find_parts(settings), registered,
                             {*small.preprocessed, small_is_source}, settings);
  if (best) speak_of_whole(*large.preprocessed, small_is_source, *best);
  return best;
}

}  // namespace emtr
