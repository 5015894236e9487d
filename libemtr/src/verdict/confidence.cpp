#include "verdict/confidence.h"

#include <algorithm>
#include <cmath>

#include "geometry/pose_distance.h"

namespace emtr {
namespace {

constexpr std::size_t kMostOthers = 10;
constexpr std::size_t kFewMatches = 10;
// Scores below the first are reached by poses that mean nothing; another pose above it with this
// share of the best score is another answer.
constexpr double kFits = 0.15, kAsGood = 0.8;
constexpr double kWithRival = 0.4;
constexpr double kEvidence = 60;  // points that lie on the other cloud; fewer fit on any plane

// A logistic model of "within 5 degrees and 0.06 radii", fitted to registrations of real pairs, to
// what remained when their right candidates were taken away, and to scans that do not belong
// together. The score holds the violation too, but by as much as ranks candidates best: a right
// pose has next to none, so that it weighs more against the best of them than among them.
constexpr double kBias = 13, kOfScore = 3.2, kOfGap = 1.4, kOfViolation = -5;
// Right poses of the noisiest scans lie up to here; wrong ones that score well are beyond it as
// often as not, and then by 0.1 to 0.5.
constexpr double kFlush = 0.7, kOfCrossing = 20;
constexpr double kLeast = 1e-3;  // of a score, fit or gap, for logarithm and quotient

double log_odds(const Candidate& best, double gap) {
  const auto logarithm = [](double value) { return std::log(std::max(value, kLeast)); };
  return kBias + kOfScore * logarithm(best.score) + kOfGap * logarithm(gap) +
         kOfViolation * std::sqrt(best.violation / std::max(best.fit.score, kLeast));
}

/// Digits that every C library's logarithm and exponential agree on; never certain.
double rounded(double confidence) { return std::min(std::round(confidence * 1e6) / 1e6, 0.999999); }

bool has_rival(const Candidate& best, const Confidence& standing) {
  if (standing.others.empty()) return false;
  return standing.others.front().score > std::max(kFits, kAsGood * best.score);
}

}  // namespace

Confidence estimate_confidence(const std::vector<Candidate>& ranked, std::size_t source, std::size_t target) {
  Confidence out;
  const Candidate& best = ranked.front();
  out.others = distinct(ranked, kDistinctPose, kMostOthers + 1);
  out.others.erase(out.others.begin());  // the best itself
  const double second = out.others.empty() ? 0 : std::max(0.0, out.others.front().score);
  out.gap = best.score - second;
  out.confidence = 1 / (1 + std::exp(-log_odds(best, out.gap)));
  // What the model has not seen: a second answer as good, and next to no points to judge by.
  if (has_rival(best, out)) out.confidence *= kWithRival;
  const double evidence = std::min(best.fit.inliers_source * static_cast<double>(source),
                                   best.fit.inliers_target * static_cast<double>(target));
  if (evidence < kEvidence) out.confidence *= kWithRival * evidence / kEvidence;
  out.confidence = rounded(out.confidence);
  return out;
}

double lower_confidence(double confidence, double surface_mismatch) {
  if (!(surface_mismatch > kFlush)) return confidence;  // NaN too: then nothing is known
  const double odds = confidence / (1 - confidence) * std::exp(-kOfCrossing * (surface_mismatch - kFlush));
  return rounded(odds / (1 + odds));
}

emtr_reason reason(const Candidate& best, const Confidence& standing, bool unconstrained,
                   std::size_t correspondences, const Settings& settings) {
  if (standing.confidence >= settings.minimum_confidence)
    return unconstrained ? EMTR_REASON_DEGENERATE : EMTR_REASON_REGISTERED;
  if (has_rival(best, standing)) return EMTR_REASON_AMBIGUOUS;
  return correspondences < kFewMatches ? EMTR_REASON_FEW_MATCHES : EMTR_REASON_LOW_OVERLAP;
}

}  // namespace emtr
