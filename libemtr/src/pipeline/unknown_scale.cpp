#include "pipeline/unknown_scale.h"

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "pipeline/scale_of_matches.h"
#include "pipeline/scale_search.h"
#include "pipeline/similarity_result.h"
#include "pipeline/solve.h"
#include "settings/choices.h"
#include "util/held_stage.h"

namespace emtr {
namespace {

constexpr double kRivalGap = 0.02;  // of the scores of two similarities
/// A rigid run whose scale was so far off is made again at the refined one.
constexpr double kOff = 0.02;  // of the logarithm
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
        seconds_(seconds),
        range_(scale_range(*source.preprocessed, *target.preprocessed, settings)),
        search_(source, target, range_, settings, token) {}

  std::unique_ptr<Result> run() {
    if (settings_.scale == ScaleSearched::Bounded &&
        settings_.scale_minimum == settings_.scale_maximum)
      return register_at(at(settings_.scale_minimum), settings_);
    if (settings_.correspondences) return run_by_matches();
    const bool stopped_early = !look(&UnknownScale::search_first);
    std::unique_ptr<Result> first;
    if (!stopped_early && best()) {
      Settings once = settings_;
      once.fallback_search = static_cast<std::int32_t>(When::Off);
      first = register_at(*best(), once);
      if (is_sure(*first) || token_.cancelled()) return first;
    }
    if (!stopped_early) look(&UnknownScale::search_rest);
    std::unique_ptr<Result> second = register_at(best().value_or(at(range_.guess)), settings_);
    if (first && first->confidence > second->confidence) second = std::move(first);
    return second->registered || token_.cancelled() ? std::move(second)
                                                    : try_likely(std::move(second));
  }

 private:
  /// Returns a scale of which no pose is known.
  static ScaleHypothesis at(double scale) { return {{scale, {}}, 0}; }

  /// Registers with the fallback search at the likeliest scales, which the quick looks had without
  /// it, until a result convinces; returns the surest.
  std::unique_ptr<Result> try_likely(std::unique_ptr<Result> surest) {
    if (exact()) return surest;
    std::size_t tries = 0;
    for (const double scale : search_.likely_scales(kLikely)) {
      if (tries == kTries || surest->registered || token_.cancelled()) break;
      if (std::abs(std::log(scale / surest->scale)) < kTriedBefore) continue;
      auto other = register_at(at(scale), settings_);
      if (other->confidence > surest->confidence) surest = std::move(other);
      ++tries;
    }
    return surest;
  }

  std::unique_ptr<Result> run_by_matches() {
    std::optional<ScaleHypothesis> found;
    const CancellationScope scope(&token_);
    try {
      const HeldStage held(token_, Stage::ScaleSearch);
      found = scale_of_matches(source_, target_, range_, settings_);
    } catch (const Cancelled&) {
    }
    return register_at(found.value_or(at(range_.guess)), settings_);
  }

  bool exact() const { return settings_.scale == ScaleSearched::Units; }

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
    if (exact())
      search_.search_at(unit_factors(range_).front());
    else
      search_.search_near();
  }

  void search_rest() {
    if (!exact()) return search_.search_everywhere();
    for (const double unit : unit_factors(range_)) search_.search_at(unit);
  }

  /// Returns the best hypothesis; at a unit exactly where the scale is to be one.
  std::optional<ScaleHypothesis> best() const {
    for (ScaleHypothesis hypothesis : search_.ranked()) {
      if (!exact()) return hypothesis;
      for (const double unit : unit_factors(range_))
        if (std::abs(std::log(hypothesis.similarity.scale / unit)) < kUnitTolerance) {
          hypothesis.similarity.scale = unit;
          return hypothesis;
        }
    }
    return std::nullopt;
  }

  bool is_sure(const Result& result) const {
    return result.registered && result.confidence >= settings_.fallback_confidence;
  }

  /// Registers the source at the scale of a hypothesis, whose pose is one of the candidates.
  std::unique_ptr<Result> register_at(const ScaleHypothesis& hypothesis, const Settings& settings) {
    double scale = hypothesis.similarity.scale;
    for (bool again = !exact();; again = false) {
      Settings at_scale = settings_at_scale(settings, scale);
      if (!at_scale.has_guess && hypothesis.score > 0) {
        at_scale.has_guess = 1;
        to_matrix(hypothesis.similarity.pose, at_scale.guess);
      }
      InputCloud source{nullptr, source_.preprocessed->rescaled(scale)},
          target{nullptr, target_.preprocessed};
      const auto problem = make_problem(source, target, at_scale, token_, Stages::Needed, seconds_);
      const Solution found = search_pose(*problem, token_);
      const SimilarityFit fit = refine_similarity(*problem, found);
      const double off = std::log(fit.similarity.scale);
      if (again && fit.succeeded && std::abs(off) > kOff && !found.stopped) {
        scale *= fit.similarity.scale;
        continue;
      }
      auto result = conclude(*problem, found, token_);
      write_similarity(*problem, found, scale, fit, exact(), *result);
      if (found.stopped) {
        if (!found.pose && hypothesis.score > 0) take_best_so_far(hypothesis, *result);
        return result;
      }
      judge_scale(fit, exact(), settings, *result);
      add_rivals(hypothesis, *result);
      return result;
    }
  }

  static void take_best_so_far(const ScaleHypothesis& hypothesis, Result& result) {
    to_matrix(hypothesis.similarity, result.transformation);
    result.scale = hypothesis.similarity.scale;
  }

  /// Takes hypotheses that fit about as well as the one that led to the result for its rivals.
  void add_rivals(const ScaleHypothesis& hypothesis, Result& result) const {
    const auto found = similarity_from_matrix(result.transformation);
    if (!found) return;
    const double score = hypothesis.score > 0 ? hypothesis.score : result.surface_fit;
    std::vector<ScaleHypothesis> rivals;
    for (const ScaleHypothesis& other : search_.ranked())
      if (other.score > score - kRivalGap && other.score > 0 &&
          !search_.is_same(other.similarity, *found))
        rivals.push_back(other);
    if (score > 0) add_rival_scales(rivals, score, settings_, result);
  }

  const InputCloud &source_, &target_;
  const Settings& settings_;
  CancellationToken& token_;
  const StageSeconds seconds_;
  const ScaleRange range_;
  ScaleSearch search_;
};

}  // namespace

std::unique_ptr<Result> register_unknown_scale(const InputCloud& source, const InputCloud& target,
                                               const Settings& settings, CancellationToken& token,
                                               const StageSeconds& seconds) {
  return UnknownScale(source, target, settings, token, seconds).run();
}

}  // namespace emtr
