#include "pipeline/unknown_scale.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "pipeline/registration_at_scale.h"
#include "pipeline/rival_results.h"
#include "pipeline/scale_of_matches.h"
#include "pipeline/scale_search.h"
#include "settings/choices.h"
#include "util/held_stage.h"
#include "verdict/confidence.h"

namespace emtr {
namespace {

/// A hypothesis with this share of the result's score is tried: of two bodies of one shape the
/// smaller covers less of a scene, and is as good an answer.
constexpr double kRivalShare = 0.5;
/// One with less than this share of the result's confidence, after a rigid run at its scale, is no
/// rival.
constexpr double kRivalConfidence = 0.5;
constexpr std::size_t kMostRivals = 2;
constexpr double kUnitTolerance = 0.06;
constexpr std::size_t kLikely = 5, kTries = 2;
constexpr double kTriedBefore = 0.1;  // of the logarithm

class UnknownScale {
 public:
  UnknownScale(const InputCloud& source, const InputCloud& target, const Settings& settings,
               CancellationToken& token, const StageSeconds& seconds)
      : source_(source),
        target_(target),
        settings_(settings),
        token_(token),
        range_(scale_range(*source.preprocessed, *target.preprocessed, settings)),
        // NOLINTNEXTLINE(clang-analyzer-optin.cplusplus.UninitializedObject): none is
        search_(source, target, range_, settings, token),
        register_at_(source, target, settings, token, seconds) {}

  std::unique_ptr<Result> run() {
    if (is_known_scale(settings_))
      return register_at_(scale_without_pose(settings_.scale_minimum), true);
    if (settings_.correspondences) return run_by_matches();
    const bool stopped_early = !look(&UnknownScale::search_first);
    std::unique_ptr<Result> first;
    if (!stopped_early && best()) {
      first = register_at_(*best(), false);
      if (is_sure(*first)) first = compare_with_rivals(std::move(first));
      if (is_sure(*first) || token_.cancelled()) return first;
    }
    if (!stopped_early) look(&UnknownScale::search_rest);
    std::unique_ptr<Result> second = register_at_(best().value_or(likeliest()), true);
    if (first && first->confidence == first->confidence &&
        !(second->confidence >= first->confidence)) {
      first->reason = token_.cancelled() ? second->reason : first->reason;
      first->registered = first->registered && !token_.cancelled();
      second = std::move(first);
    }
    if (!second->registered && !token_.cancelled()) second = try_likely(std::move(second));
    if (second->registered && !token_.cancelled()) second = compare_with_rivals(std::move(second));
    doubt(*second);
    return second;
  }

 private:
  /// Returns the scale to try where nothing was found.
  ScaleHypothesis likeliest() const {
    return scale_without_pose(is_unit_scale(settings_)
                                  ? unit_factors(range_).front()
                                  : range_.scale(std::clamp(0.0, range_.lowest, range_.highest)));
  }

  /// Returns the unit that is as good as the scale of a hypothesis; empty where there is none.
  std::optional<ScaleHypothesis> at_unit(const ScaleHypothesis& hypothesis) const {
    for (const double unit : unit_factors(range_))
      if (std::abs(std::log(hypothesis.similarity.scale / unit)) < kUnitTolerance)
        return register_at_.rescaled(hypothesis, unit);
    return std::nullopt;
  }

  /// Registers with the fallback search at the likeliest scales, which the quick looks had without
  /// it, until a result convinces; returns the surest.
  std::unique_ptr<Result> try_likely(std::unique_ptr<Result> surest) {
    if (is_unit_scale(settings_)) return surest;
    std::size_t tries = 0;
    for (const double scale : search_.likely_scales(kLikely)) {
      if (tries == kTries || surest->registered || token_.cancelled()) break;
      if (std::abs(std::log(scale / surest->scale)) < kTriedBefore) continue;
      auto other = register_at_(scale_without_pose(scale), true);
      if (other->confidence > surest->confidence) surest = std::move(other);
      ++tries;
    }
    return surest;
  }

  /// Lowers the confidence of what was found by a search of all scales.
  void doubt(Result& result) const {
    if (!(result.confidence > 0)) return;
    result.confidence = lower_for_many_scales(result.confidence);
    if (!result.registered || result.confidence >= settings_.minimum_confidence) return;
    result.registered = 0;
    result.reason = EMTR_REASON_LOW_OVERLAP;
  }

  std::unique_ptr<Result> run_by_matches() {
    std::optional<ScaleHypothesis> found;
    try {
      const CancellationScope scope(&token_);
      const HeldStage held(token_, Stage::ScaleSearch);
      found = scale_of_matches(source_, target_, range_, settings_);
    } catch (const Cancelled&) {
    }
    if (found && is_unit_scale(settings_)) found = at_unit(*found);
    return register_at_(found.value_or(likeliest()), true);
  }

  /// Runs a part of the search as one stage; returns false when the token stopped it.
  bool look(void (UnknownScale::*part)()) {
    const CancellationScope scope(&token_);
    const HeldStage held(token_, Stage::ScaleSearch);
    try {
      (this->*part)();
      return true;
    } catch (const Cancelled&) {
      return false;
    }
  }

  void search_first() {
    if (is_unit_scale(settings_))
      search_.search_at(unit_factors(range_).front());
    else
      search_.search_near();
  }

  void search_rest() {
    if (!is_unit_scale(settings_)) return search_.search_everywhere();
    for (const double unit : unit_factors(range_)) search_.search_at(unit);
  }

  /// Returns the hypothesis at a scale that is allowed, if there is one.
  std::optional<ScaleHypothesis> allowed(const ScaleHypothesis& hypothesis) const {
    if (is_unit_scale(settings_)) return at_unit(hypothesis);
    return register_at_.rescaled(hypothesis,
                                 register_at_.within_bounds(hypothesis.similarity.scale));
  }

  std::optional<ScaleHypothesis> best() const {
    for (const ScaleHypothesis& hypothesis : search_.ranked())
      if (auto found = allowed(hypothesis)) return found;
    return std::nullopt;
  }

  /// Without candidates there is no confidence, and the verdict is the fitness's.
  bool is_sure(const Result& result) const {
    return result.registered && !(result.confidence < settings_.fallback_confidence);
  }

  /// Registers the source at the rivals of a result. Those that are nearly as sure make it
  /// ambiguous, and the surest is returned.
  std::unique_ptr<Result> compare_with_rivals(std::unique_ptr<Result> surest) {
    std::vector<std::unique_ptr<Result>> found;
    for (const ScaleHypothesis& hypothesis : rivals_of(*surest)) {
      std::unique_ptr<Result> other = register_at_(hypothesis, false);
      if (token_.cancelled()) {
        surest->reason = other->reason;
        surest->registered = 0;
        return surest;
      }
      if (is_same_scale(other->scale, surest->scale) ||
          !(other->confidence >= kRivalConfidence * surest->confidence))
        continue;
      if (other->confidence > surest->confidence) std::swap(surest, other);
      found.push_back(std::move(other));
    }
    std::vector<const Result*> rivals;
    rivals.reserve(found.size());
    for (const auto& other : found) rivals.push_back(other.get());
    add_rivals(rivals, settings_.minimum_confidence, *surest);
    return surest;
  }

  /// Returns the best hypotheses at other scales that score about as well as a result. Other poses
  /// at its own scale are known to the rigid run there.
  std::vector<ScaleHypothesis> rivals_of(const Result& result) const {
    std::vector<ScaleHypothesis> out;
    const auto& ranked = search_.ranked();
    const auto own = std::find_if(ranked.begin(), ranked.end(), [&](const auto& hypothesis) {
      return is_same_scale(hypothesis.similarity.scale, result.scale);
    });
    const double least = kRivalShare * (own != ranked.end() ? own->score : result.surface_fit);
    for (const ScaleHypothesis& other : ranked) {
      if (out.size() == kMostRivals || !(other.score > least)) break;
      const auto rival = allowed(other);
      if (!rival || is_same_scale(rival->similarity.scale, result.scale)) continue;
      const bool known = std::any_of(out.begin(), out.end(), [&](const ScaleHypothesis& earlier) {
        return is_same_scale(earlier.similarity.scale, rival->similarity.scale);
      });
      if (!known) out.push_back(*rival);
    }
    return out;
  }

  const InputCloud &source_, &target_;
  const Settings& settings_;
  CancellationToken& token_;
  const ScaleRange range_;
  ScaleSearch search_;
  const RegistrationAtScale register_at_;
};

}  // namespace

std::unique_ptr<Result> register_unknown_scale(const InputCloud& source, const InputCloud& target,
                                               const Settings& settings, CancellationToken& token,
                                               const StageSeconds& seconds) {
  return UnknownScale(source, target, settings, token, seconds).run();
}

}  // namespace emtr
