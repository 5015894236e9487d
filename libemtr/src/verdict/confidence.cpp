#include "verdict/confidence.h"

#include <algorithm>
#include <cmath>

#include "geometry/pose_distance.h"

namespace emtr {
namespace {

constexpr std::size_t kMaximumAlternatives = 10;
constexpr std::size_t kFewMatches = 10;
// Scores below the first are reached by poses that mean nothing; another pose above it with this
// share of the best score is another answer, a rival.
constexpr double kMeaningfulScore = 0.03, kRivalShare = 0.75;
// One of 190 registered scans of other sources has another answer with 0.3 of the score.
constexpr double kNearlyRivalShare = 0.5;
// Scans from one place lie on each other by their pattern of points alone.
constexpr double kRivalShareFromOnePlace = 0.3;
// A clean rival fits where it overlaps as well as the best does, and sees as little in front of the
// sensors: the best only overlaps more, as scans of a symmetric object do in a wrong pose. Of right
// poses of real scans next to none has one.
constexpr double kCleanRivalShare = 0.45, kCleanPrecision = 0.92, kCleanViolation = 0.006;
constexpr double kRivalFactor = 0.4, kFewPointsFactor = 0.4, kChangedFactor = 0.1;
// Factor of the odds: one of 40 pairs that do not belong together had 0.63 at some scale.
constexpr double kManyScalesFactor = 0.5;
// How much better a changed source must fit: a scene that is its own mirror image fits as well.
constexpr double kBetterShare = 1.15, kBetterBy = 0.02;
// 95 of 100 right poses have more of the weight than this share of the points.
constexpr double kDistinctiveShare = 0.4;
// Planes that lie on each other while the rest of the clouds does not: 0.07 to 0.14.
constexpr double kLeastExplained = 0.2;
constexpr double kFewPoints = 60;  // that lie on the other cloud; fewer fit on any plane

// A logistic model of "within 5 degrees and 0.06 radii", by tools/bench/fit_confidence: fitted to
// registrations of real pairs, to what remained when their right candidates were taken away, and to
// scans that do not belong together.
constexpr double kBias = -2.2, kGapWeight = 2.33, kViolationWeight = -16.9, kEvidenceWeight = 2.02;
// Right poses of the noisiest scans lie up to here; wrong ones that score well are beyond it as
// often as not, and then by 0.1 to 0.5.
constexpr double kFlushMismatch = 0.7, kMismatchWeight = 20;
// Outlines of unrelated floor plans, all straight walls at right angles, reach scores of 0.3; those
// that overlap by half and more have 0.5 to 0.6.
constexpr double kOutlineBias = 0.5, kOutlineScoreWeight = 8;
constexpr double kMinimum = 1e-3;  // of a score, fit or gap, for logarithm and quotient

double log_odds(const Candidate& best, double score_gap, double evidence) {
  const auto logarithm = [](double value) { return std::log(std::max(value, kMinimum)); };
  return kBias + kGapWeight * logarithm(score_gap) +
         kViolationWeight * std::sqrt(best.violation / std::max(best.fit.score, kMinimum)) +
         kEvidenceWeight * std::log(std::max(evidence, 1.0));
}

/// Rounds to digits that every C library's logarithm and exponential agree on; never certain.
double rounded(double probability) {
  return std::min(std::round(probability * 1e6) / 1e6, 0.999999);
}

bool is_another_answer(double score, double best, double share) {
  return score > std::max(kMeaningfulScore, share * best);
}

/// Returns the share of what lies near the other surface that lies on it.
double precision(const Candidate& candidate) {
  return candidate.fit.score / std::max(candidate.fit.near, kMinimum);
}

bool is_clean_rival(const Candidate& other, const Candidate& best) {
  return is_another_answer(other.score, best.score, kCleanRivalShare) &&
         precision(other) >= kCleanPrecision * precision(best) &&
         other.violation <= best.violation + kCleanViolation;
}

bool has_rival(const Candidate& best, const std::vector<Candidate>& alternatives) {
  const double share = best.shares_pattern ? kRivalShareFromOnePlace : kRivalShare;
  return std::any_of(alternatives.begin(), alternatives.end(), [&](const Candidate& other) {
    return is_another_answer(other.score, best.score, share) || is_clean_rival(other, best);
  });
}

}  // namespace

bool is_rival_score(double score, double best) {
  return is_another_answer(score, best, kRivalShare);
}

bool is_mostly_plane(const Candidate& candidate) {
  const double inliers = (candidate.fit.inliers_source + candidate.fit.inliers_target) / 2;
  return candidate.fit.score < kDistinctiveShare * inliers;
}

bool is_hardly_explained(const Candidate& candidate) {
  return candidate.fit.near < kLeastExplained;
}

bool is_nearly_rivaled(const Candidate& best, const Confidence& confidence) {
  return confidence.score_gap < (1 - kNearlyRivalShare) * best.score;
}

double evidence(const Candidate& candidate, std::size_t source, std::size_t target) {
  return std::min(candidate.fit.inliers_source * static_cast<double>(source),
                  candidate.fit.inliers_target * static_cast<double>(target));
}

Confidence estimate_confidence(const std::vector<Candidate>& ranked, std::size_t source,
                               std::size_t target) {
  Confidence out;
  const Candidate& best = ranked.front();
  out.alternatives = suppress_non_maxima(ranked, kDistinctPose, kMaximumAlternatives + 1);
  out.alternatives.erase(out.alternatives.begin());  // the best itself
  const double second =
      out.alternatives.empty() ? 0 : std::max(0.0, out.alternatives.front().score);
  out.score_gap = best.score - second;
  out.evidence = evidence(best, source, target);
  double probability = 1 / (1 + std::exp(-log_odds(best, out.score_gap, out.evidence)));
  // What the model has not seen: a second answer as good, and next to no points to judge by.
  if (has_rival(best, out.alternatives)) probability *= kRivalFactor;
  if (out.evidence < kFewPoints) probability *= kFewPointsFactor * out.evidence / kFewPoints;
  out.probability = rounded(probability);
  return out;
}

double lower_for_rival(double probability) { return rounded(kRivalFactor * probability); }

double lower_for_many_scales(double probability) {
  const double odds = kManyScalesFactor * probability / (1 - probability);
  return rounded(odds / (1 + odds));
}

void weigh_changed_source(const Candidate& best, double mirrored, const Rescaled& rescaled,
                          Confidence& confidence) {
  const auto better = [&](double score) { return score > kBetterShare * best.score + kBetterBy; };
  confidence.mirrored = better(mirrored);
  if (rescaled.factor != 1 && better(rescaled.score)) confidence.scale_factor = rescaled.factor;
  if (confidence.mirrored || confidence.scale_factor != 1)
    confidence.probability = rounded(kChangedFactor * confidence.probability);
}

double lower_confidence(double probability, double surface_mismatch) {
  if (!(surface_mismatch > kFlushMismatch)) return probability;  // NaN too: then nothing is known
  const double odds = probability / (1 - probability) *
                      std::exp(-kMismatchWeight * (surface_mismatch - kFlushMismatch));
  return rounded(odds / (1 + odds));
}

double lower_outline_confidence(double probability, double score) {
  const double factor =
      std::exp(kOutlineBias + kOutlineScoreWeight * std::log(std::max(score, kMinimum)));
  const double odds = probability / (1 - probability) * std::min(factor, 1.0);
  return rounded(odds / (1 + odds));
}

emtr_reason reason(const Candidate& best, const Confidence& confidence, bool unconstrained,
                   std::size_t correspondences, const Settings& settings) {
  if (confidence.probability >= settings.minimum_confidence)
    return unconstrained ? EMTR_REASON_DEGENERATE : EMTR_REASON_REGISTERED;
  if (confidence.mirrored) return EMTR_REASON_MIRRORED;
  if (confidence.scale_factor != 1) return EMTR_REASON_SCALE;
  if (has_rival(best, confidence.alternatives)) return EMTR_REASON_AMBIGUOUS;
  return correspondences < kFewMatches ? EMTR_REASON_FEW_MATCHES : EMTR_REASON_LOW_OVERLAP;
}

}  // namespace emtr
