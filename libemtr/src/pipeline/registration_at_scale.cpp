#include "pipeline/registration_at_scale.h"

#include <algorithm>
#include <cmath>

#include "pipeline/similarity_result.h"
#include "pipeline/solve.h"
#include "settings/choices.h"

namespace emtr {
namespace {

/// A rigid run whose scale was so far off is made again at the refined one.
constexpr double kOff = 0.02;           // of the logarithm
constexpr double kOffUnrefined = 2e-3;  // where the refined scale cannot be taken with its pose
/// How often: a pose that does not convince seldom leads to the right one.
constexpr int kMostPasses = 8, kMostPassesInDoubt = 3;

bool is_convincing(const Solution& found, const Settings& settings) {
  return found.confidence && found.confidence->probability >= settings.minimum_confidence;
}

SimilarityFit refined(const Problem& problem, Solution& found, CancellationToken& token) {
  const CancellationScope scope(&token);
  try {
    return refine_similarity(problem, found);
  } catch (const Cancelled&) {
    found.stopped = true;
    return {};
  }
}

void take_best_so_far(const ScaleHypothesis& hypothesis, Result& result) {
  to_matrix(hypothesis.similarity, result.transformation);
  result.scale = hypothesis.similarity.scale;
}

}  // namespace

bool is_unit_scale(const Settings& settings) { return settings.scale == ScaleSearched::Units; }

bool is_known_scale(const Settings& settings) {
  return settings.scale == ScaleSearched::Bounded &&
         settings.scale_minimum == settings.scale_maximum;
}

RegistrationAtScale::RegistrationAtScale(const InputCloud& source, const InputCloud& target,
                                         const Settings& settings, CancellationToken& token,
                                         const StageSeconds& seconds)
    : source_(source), target_(target), settings_(settings), token_(token), seconds_(seconds) {}

std::unique_ptr<Result> RegistrationAtScale::operator()(const ScaleHypothesis& start,
                                                        bool fallback) const {
  const bool exact = is_known_scale(settings_) || is_unit_scale(settings_);
  ScaleHypothesis hypothesis = start;
  for (int pass = 1;; ++pass) {
    const double scale = hypothesis.similarity.scale;
    InputCloud source{nullptr, source_.preprocessed->rescaled(scale)},
        target{nullptr, target_.preprocessed};
    const auto problem = make_problem(source, target, settings_for(hypothesis, fallback), token_,
                                      Stages::Needed, seconds_);
    Solution found = search_pose(*problem, token_);
    const SimilarityFit fit = refined(*problem, found, token_);
    const double refined_scale = within_bounds(scale * fit.similarity.scale);
    const double off = std::abs(std::log(refined_scale / scale));
    // A prior speaks of the pose of a rigid run: the last one's is not moved any more.
    const bool keeps_scale =
        exact || problem->prior != nullptr || refined_scale != scale * fit.similarity.scale;
    const double most = keeps_scale ? kOffUnrefined : kOff;
    const int passes = is_convincing(found, settings_) ? kMostPasses : kMostPassesInDoubt;
    if (!exact && fit.succeeded && !found.stopped && off > most && pass < passes) {
      Similarity similarity = problem->pair.normalization.to_user(fit.similarity);
      similarity.scale *= scale;
      hypothesis = rescaled({similarity, 1}, refined_scale);  // 1: its pose is known
      continue;
    }
    auto result = conclude(*problem, found, token_);
    write_similarity(*problem, found, scale, fit, keeps_scale, *result);
    if (!found.stopped)
      judge_scale(fit, exact, settings_, *result);
    else if (!found.pose && hypothesis.score > 0)
      take_best_so_far(hypothesis, *result);
    return result;
  }
}

ScaleHypothesis RegistrationAtScale::rescaled(ScaleHypothesis hypothesis, double scale) const {
  Similarity& similarity = hypothesis.similarity;
  similarity.pose.t += (similarity.scale - scale) *
                       similarity.rotate(Eigen::Vector3d::Map(source_.preprocessed->center));
  similarity.scale = scale;
  return hypothesis;
}

double RegistrationAtScale::within_bounds(double scale) const {
  const bool bounded = settings_.scale == ScaleSearched::Bounded;
  return bounded ? std::clamp(scale, settings_.scale_minimum, settings_.scale_maximum) : scale;
}

/// Returns the settings of a rigid run, with the hypothesis for a guess unless the user has one.
Settings RegistrationAtScale::settings_for(const ScaleHypothesis& hypothesis, bool fallback) const {
  Settings out = settings_at_scale(settings_, hypothesis.similarity.scale);
  if (!fallback) out.fallback_search = static_cast<std::int32_t>(When::Off);
  if (out.has_guess || !(hypothesis.score > 0)) return out;
  out.has_guess = 1;
  to_matrix(hypothesis.similarity.pose, out.guess);
  return out;
}

}  // namespace emtr
