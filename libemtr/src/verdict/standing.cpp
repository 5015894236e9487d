#include "standing.h"

#include <algorithm>
#include <cmath>

#include "../candidates/modes.h"

namespace emtr {
namespace {

constexpr std::size_t kMostOthers = 10;
constexpr std::size_t kFewMatches = 10;
constexpr double kFits = 0.15;   // scores below it are reached by poses that mean nothing
constexpr double kAsGood = 0.8;  // of the best score, to be another answer instead of a worse one

// A logistic model of "within 5 degrees and 0.06 radii" in the logarithms of score and gap, fitted
// to registrations of real pairs, before and after an escalation, and to what remained when the
// right candidates were taken away.
constexpr double kBias = 19.1, kOfScore = 5.3, kOfGap = 2.05;
constexpr double kLeast = 1e-3;  // of a score or gap, for its logarithm

}  // namespace

Standing stand(const std::vector<Candidate>& ranked) {
  Standing out;
  const Candidate& best = ranked.front();
  for (const Candidate& c : ranked) {
    if (out.others.size() == kMostOthers) break;
    const auto same = [&](const Candidate& other) { return within(c.pose, other.pose, kMode); };
    if (same(best) || std::any_of(out.others.begin(), out.others.end(), same)) continue;
    out.others.push_back(c);
  }
  const double second = out.others.empty() ? 0 : std::max(0.0, out.others.front().score);
  out.gap = best.score - second;
  const auto logarithm = [](double value) { return std::log(std::max(value, kLeast)); };
  const double odds = kBias + kOfScore * logarithm(best.score) + kOfGap * logarithm(out.gap);
  out.confidence = 1 / (1 + std::exp(-odds));
  return out;
}

emtr_reason reason(const Candidate& best, const Standing& standing, bool slides,
                   std::size_t correspondences, const Settings& settings) {
  if (standing.confidence >= settings.minimum_confidence)
    return slides ? EMTR_REASON_DEGENERATE : EMTR_REASON_REGISTERED;
  if (correspondences < kFewMatches) return EMTR_REASON_FEW_MATCHES;
  const bool rival = !standing.others.empty() && best.score > 0 &&
                     standing.others.front().score > kAsGood * best.score;
  return rival && best.score > kFits ? EMTR_REASON_AMBIGUOUS : EMTR_REASON_LOW_OVERLAP;
}

}  // namespace emtr
