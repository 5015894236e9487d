#include "verdict/match_verdict.h"

#include <algorithm>
#include <cmath>

namespace emtr {
namespace {

constexpr double kPriorOdds = 10;     // of a wrong pose against a right one, before the matches
constexpr double kRivalFactor = 0.4;  // as among surfaces
constexpr double kLoose = 0.05;       // radii, or radians, that noise may move a pose
constexpr double kRounding = 1e-7;    // noise of exact matches in floats
constexpr double kLine = 1e-10;       // eigenvalue of points that floats put on one line

/// Adds a match in all three directions.
void add(NormalEquations& sums, const Eigen::Vector3d& y, const Eigen::Vector3d& d) {
  sums.add_difference(y.data(), d.data(), 1);
  for (int a = 0; a < 3; ++a) {
    const Eigen::Vector3d axis = Eigen::Vector3d::Unit(a);
    const double J[6] = {y.y() * axis.z() - y.z() * axis.y(),
                         y.z() * axis.x() - y.x() * axis.z(),
                         y.x() * axis.y() - y.y() * axis.x(),
                         axis.x(),
                         axis.y(),
                         axis.z()};
    sums.add_normal(J, d[a], 1);
    sums.weights += 1;
  }
}

}  // namespace

MatchVerdict judge_matches(const std::vector<MatchPose>& poses, bool unconstrained,
                           const Settings& settings) {
  MatchVerdict out;
  const double wrong = kPriorOdds * std::pow(10.0, poses.front().log_chance);
  const bool rival = poses.size() > 1;
  const double probability = (rival ? kRivalFactor : 1) / (1 + wrong);
  out.confidence = std::min(std::round(probability * 1e6) / 1e6, 0.999999);
  if (out.confidence >= settings.minimum_confidence)
    out.reason = unconstrained ? EMTR_REASON_DEGENERATE : EMTR_REASON_REGISTERED;
  else if (rival)
    out.reason = EMTR_REASON_AMBIGUOUS;
  return out;
}

Refined constraints_of(const MatchPoints& matches, const MatchPose& found, const Prior* prior) {
  NormalEquations sums;
  double squares = 0;
  for (const std::uint32_t i : found.inliers) {
    const Eigen::Vector3d y = found.pose * point_of(matches.p, i), q = point_of(matches.q, i);
    add(sums, y, y - q);
    const double r = distance(y, q);
    squares += r * r;
  }
  Refined out;
  out.pose = found.pose;
  out.succeeded = found.inliers.size() >= 3;
  if (!out.succeeded) return out;
  out.rmse = std::sqrt(squares / static_cast<double>(found.inliers.size()));
  const double noise = std::max(found.noise, kRounding);
  sums.normal_matrix(out.information);
  for (double& value : out.information) value /= noise * noise;
  HessianSpectrum& spectrum = out.hessian_spectrum;
  spectrum = hessian_spectrum(sums);
  const auto is_open = [&](double eigenvalue) {
    const double most = kLoose * spectrum.radius;
    return eigenvalue < kLine || noise * noise > most * most * eigenvalue * sums.weights;
  };
  spectrum.unconstrained =
      static_cast<int>(std::count_if(spectrum.eigenvalues, spectrum.eigenvalues + 6, is_open));
  out.unconstrained = spectrum.unconstrained;
  if (prior && out.unconstrained > 0)
    out.unconstrained =
        std::min(out.unconstrained, unconstrained_within(spectrum, prior->limits(found.pose)));
  return out;
}

}  // namespace emtr
