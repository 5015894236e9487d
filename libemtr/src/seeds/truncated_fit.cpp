#include "seeds/truncated_fit.h"

#include <algorithm>
#include <type_traits>
#include <vector>

#include "seeds/procrustes.h"

namespace emtr {
namespace {

constexpr double kStep = 1.4;            // of the control parameter, as in the paper
constexpr double kDeviations = 4.03;     // within which 99.9 % of residuals in three numbers are
constexpr double kMedianNoise = 1.5382;  // median of a residual over the noise of a coordinate
constexpr double kRounding = 4e-7;       // residual of exact matches in floats
constexpr double kSlack = 1.2;           // the fit itself changes residuals
constexpr int kRounds = 4, kLast = 20;

std::vector<double> residuals(const MatchPoints& matches, const Rigid& pose) {
  std::vector<double> out(matches.size());
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] = distance(pose * point_of(matches.p, i), point_of(matches.q, i));
  return out;
}

/// Returns the weight of a residual r, relative to the threshold, under the surrogate of mu.
double weight(double r, double mu) {
  const double rr = r * r;
  if (rr <= mu / (mu + 1)) return 1;
  if (rr >= (mu + 1) / mu) return 0;
  return std::sqrt(mu * (mu + 1)) / r - mu;
}

Rigid weighted_pose(const MatchPoints& matches, const Rigid& pose, double threshold, double mu) {
  const std::vector<double> r = residuals(matches, pose);
  Procrustes sums;
  std::size_t count = 0;
  for (std::size_t i = 0; i < r.size(); ++i) {
    const double w = weight(r[i] / threshold, mu);
    if (!(w > 0)) continue;
    sums.add(point_of(matches.p, i), point_of(matches.q, i), w);
    ++count;
  }
  return count < 3 ? pose : sums.pose();
}

/// Lowers the convexity until the weights are 0 or 1, and goes on until the pose stays.
Rigid anneal(const MatchPoints& matches, Rigid pose, double threshold) {
  double mu = 0.5;
  while (mu < 1e3) {
    pose = weighted_pose(matches, pose, threshold, mu);
    mu *= kStep;
  }
  for (int k = 0; k < kLast; ++k) {
    const Rigid next = weighted_pose(matches, pose, threshold, 1e6);
    const bool stays = next.R == pose.R && next.t == pose.t;
    pose = next;
    if (stays) break;
  }
  return pose;
}

/// Returns the noise of a coordinate, from the residuals up to the threshold.
double noise_of(const MatchPoints& matches, const Rigid& pose, double threshold) {
  std::vector<double> r = residuals(matches, pose);
  r.erase(std::remove_if(r.begin(), r.end(), [=](double d) { return d > threshold; }), r.end());
  if (r.size() < 4) return threshold / kDeviations;  // three determine the pose and no noise
  const auto middle = r.begin() + static_cast<std::ptrdiff_t>(r.size() / 2);
  std::nth_element(r.begin(), middle, r.end());
  // The fitted pose takes six of the matches' numbers.
  const double n = static_cast<double>(r.size());
  return *middle / kMedianNoise * std::sqrt(n / (n - 2));
}

}  // namespace

TruncatedFit truncated_fit(const MatchPoints& matches, const Rigid& start, double radius) {
  const double least = std::max(kSlack * radius, kRounding);
  TruncatedFit out{start, 0, least};
  for (int k = 0; k < kRounds; ++k) {
    out.pose = anneal(matches, out.pose, out.threshold);
    out.noise = noise_of(matches, out.pose, out.threshold);
    const double next = std::max(kDeviations * out.noise, least);
    if (next == out.threshold) break;
    out.threshold = next;
  }
  return out;
}

}  // namespace emtr
