#include "verdict/color_verdict.h"

#include <algorithm>
#include <cmath>

namespace emtr {
namespace {

constexpr double kScoreWeight = 4;
constexpr double kMinimumScore = 1e-3;
// Natural logarithms of odds: against chance in any of the poses, and against each other candidate.
constexpr double kProof = 6, kMargin = 4;
// The evidence by that of the next candidate. The largest two of many that are chance are close to
// each other (at most 1.3 on four unrelated walls), whatever the colors are like; the right one's
// was 1.7 to 30 times the next on fifteen walls, floors, boxes and columns.
constexpr double kRatio = 1.5;
// Two places that are alike in part, such as the edge lines of two roads, agree by more than chance
// and by little: 0.35 in one pair, where right poses had 0.55 and more.
constexpr double kLeastCorrelation = 0.45;

double log_likelihood(const ColoredCandidate& c, double best_score) {
  const double score = std::max(c.candidate.score, kMinimumScore);
  return c.colors.evidence + kScoreWeight * std::log(score / std::max(best_score, kMinimumScore));
}

}  // namespace

bool is_more_than_chance(double evidence, std::size_t poses) {
  return evidence > kProof + std::log(1 + static_cast<double>(poses));
}

ColorVerdict judge_by_colors(const std::vector<ColoredCandidate>& candidates,
                             std::size_t looked_at) {
  ColorVerdict out;
  if (candidates.empty()) return out;
  double best_score = 0;
  for (const ColoredCandidate& c : candidates) best_score = std::max(best_score, c.candidate.score);
  std::vector<double> likelihood;
  likelihood.reserve(candidates.size());
  for (const ColoredCandidate& c : candidates) likelihood.push_back(log_likelihood(c, best_score));
  const auto best = std::max_element(likelihood.begin(), likelihood.end());
  out.best = static_cast<std::size_t>(best - likelihood.begin());
  double others = 0;
  bool clear = true;
  for (std::size_t i = 0; i < likelihood.size(); ++i) {
    if (i == out.best) continue;
    others += std::exp(likelihood[i] - *best);
    clear = clear && *best - likelihood[i] > kMargin &&
            candidates[out.best].colors.evidence > kRatio * candidates[i].colors.evidence;
  }
  out.decided = clear && candidates[out.best].colors.correlation > kLeastCorrelation &&
                is_more_than_chance(*best, looked_at);
  // Rounded to digits that every C library's exponential agrees on.
  out.probability = std::min(std::round(1e6 / (1 + others)) / 1e6, 0.999999);
  return out;
}

}  // namespace emtr
