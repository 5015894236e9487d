#include "pipeline/unknown_scale.h"

#include <algorithm>
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
#include "verdict/confidence.h"

namespace emtr {
namespace {

constexpr double kRivalGap = 0.02;  // of the scores of two similarities
/// A rigid run whose scale was so far off is made again at the refined one.
constexpr double kOff = 0.02;           // of the logarithm
constexpr double kOffUnrefined = 2e-3;  // where the refined scale cannot be taken with its pose
constexpr int kMostPasses = 3;
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
        // NOLINTNEXTLINE(clang-analyzer-optin.cplusplus.UninitializedObject): none is
        search_(source, target, range_, settings, token) {}

  std::unique_ptr<Result> run() {
    if (is_known()) return register_at(at(settings_.scale_minimum), settings_);
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
    std::unique_ptr<Result> second = register_at(best().value_or(likeliest()), settings_);
    if (first && first->confidence == first->confidence &&
        !(second->confidence >= first->confidence)) {
      first->reason = token_.cancelled() ? second->reason : first->reason;
      first->registered = first->registered && !token_.cancelled();
      second = std::move(first);
    }
    if (!second->registered && !token_.cancelled()) second = try_likely(std::move(second));
    doubt(*second);
    return second;
  }

 private:
  bool is_known() const {
    return settings_.scale == ScaleSearched::Bounded &&
           settings_.scale_minimum == settings_.scale_maximum;
  }
  bool is_unit() const { return settings_.scale == ScaleSearched::Units; }
  /// Tells whether the scale of a hypothesis is not to be refined.
  bool exact() const { return is_known() || is_unit(); }

  /// Returns a scale of which no pose is known.
  static ScaleHypothesis at(double scale) { return {{scale, {}}, 0}; }

  /// Returns the scale to try where nothing was found.
  ScaleHypothesis likeliest() const {
    return at(is_unit() ? unit_factors(range_).front()
                        : range_.scale(std::clamp(0.0, range_.lowest, range_.highest)));
  }

  /// Returns the hypothesis at another scale, with the source's centroid where it was.
  ScaleHypothesis rescaled(ScaleHypothesis hypothesis, double scale) const {
    Similarity& similarity = hypothesis.similarity;
    similarity.pose.t += (similarity.scale - scale) *
                         similarity.rotate(Eigen::Vector3d::Map(source_.preprocessed->center));
    similarity.scale = scale;
    return hypothesis;
  }

  /// Returns the unit that is as good as the scale of a hypothesis; empty where there is none.
  std::optional<ScaleHypothesis> at_unit(const ScaleHypothesis& hypothesis) const {
    for (const double unit : unit_factors(range_))
      if (std::abs(std::log(hypothesis.similarity.scale / unit)) < kUnitTolerance)
        return rescaled(hypothesis, unit);
    return std::nullopt;
  }

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
    if (found && is_unit()) found = at_unit(*found);
    return register_at(found.value_or(likeliest()), settings_);
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
    if (is_unit())
      search_.search_at(unit_factors(range_).front());
    else
      search_.search_near();
  }

  void search_rest() {
    if (!is_unit()) return search_.search_everywhere();
    for (const double unit : unit_factors(range_)) search_.search_at(unit);
  }

  /// Returns the best hypothesis; at a unit exactly where the scale is to be one.
  std::optional<ScaleHypothesis> best() const {
    for (const ScaleHypothesis& hypothesis : search_.ranked()) {
      if (!is_unit()) return rescaled(hypothesis, within_bounds(hypothesis.similarity.scale));
      if (auto found = at_unit(hypothesis)) return found;
    }
    return std::nullopt;
  }

  double within_bounds(double scale) const {
    const bool bounded = settings_.scale == ScaleSearched::Bounded;
    return bounded ? std::clamp(scale, settings_.scale_minimum, settings_.scale_maximum) : scale;
  }

  /// Without candidates there is no confidence, and the verdict is the fitness's.
  bool is_sure(const Result& result) const {
    return result.registered && !(result.confidence < settings_.fallback_confidence);
  }

  /// Registers the source at the scale of a hypothesis, whose pose is one of the candidates; again
  /// at the refined scale where that is another.
  std::unique_ptr<Result> register_at(const ScaleHypothesis& start, const Settings& settings) {
    ScaleHypothesis hypothesis = start;
    for (int pass = 1;; ++pass) {
      const double scale = hypothesis.similarity.scale;
      InputCloud source{nullptr, source_.preprocessed->rescaled(scale)},
          target{nullptr, target_.preprocessed};
      const auto problem = make_problem(source, target, settings_for(hypothesis, settings), token_,
                                        Stages::Needed, seconds_);
      Solution found = search_pose(*problem, token_);
      const SimilarityFit fit = refined(*problem, found);
      const double refined_scale = within_bounds(scale * fit.similarity.scale);
      const double off = std::abs(std::log(refined_scale / scale));
      // A prior speaks of the pose of a rigid run: the last one's is not moved any more.
      const bool keeps_scale =
          exact() || problem->prior != nullptr || refined_scale != scale * fit.similarity.scale;
      const double most = keeps_scale ? kOffUnrefined : kOff;
      if (!exact() && fit.succeeded && !found.stopped && off > most && pass < kMostPasses) {
        hypothesis = rescaled(hypothesis, refined_scale);
        continue;
      }
      auto result = conclude(*problem, found, token_);
      write_similarity(*problem, found, scale, fit, keeps_scale, *result);
      if (found.stopped) {
        if (!found.pose && hypothesis.score > 0) take_best_so_far(hypothesis, *result);
        return result;
      }
      judge_scale(fit, exact(), settings, *result);
      add_rivals(hypothesis, *result);
      return result;
    }
  }

  /// Returns the settings of a rigid run, with the hypothesis for a guess unless the user has one.
  static Settings settings_for(const ScaleHypothesis& hypothesis, const Settings& settings) {
    Settings out = settings_at_scale(settings, hypothesis.similarity.scale);
    if (out.has_guess || !(hypothesis.score > 0)) return out;
    out.has_guess = 1;
    to_matrix(hypothesis.similarity.pose, out.guess);
    return out;
  }

  SimilarityFit refined(const Problem& problem, Solution& found) {
    const CancellationScope scope(&token_);
    try {
      return refine_similarity(problem, found);
    } catch (const Cancelled&) {
      found.stopped = true;
      return {};
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
