#include "pipeline/similarity_result.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pipeline/scale_of_matches.h"
#include "verdict/confidence.h"

namespace emtr {
namespace {

/// Depth cameras prefer scales up to 5 percent off by their own error.
constexpr double kAnotherScale = 0.06;  // of the logarithm
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

void scale_rotation(double scale, double transformation[16]) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) transformation[4 * i + j] *= scale;
}

/// Writes the inverse of the covariance of a small rotation and a translation as information()
/// does, and of the logarithm of the scale, all about the target's center.
void write_information(const SimilarityEquations& sums, const Eigen::Vector3d& source_origin,
                       double design_effect, double unit, double out[49]) {
  // u.y = u.(y - o) + u.o
  Matrix7 about_center = Matrix7::Identity();
  about_center.block<1, 3>(6, 3) = source_origin.transpose();
  about_center.block<3, 3>(3, 3) /= unit;  // a translation in the user's unit
  const Matrix7 H = sums.H.selfadjointView<Eigen::Upper>();
  const double bend = sums.slopes / sums.weights, variance = sums.squared_influence / sums.weights;
  Matrix7::Map(out) =
      about_center * H * about_center.transpose() * (bend * bend / (variance * design_effect));
}

}  // namespace

SimilarityFit refine_similarity(const Problem& problem, const Solution& found) {
  if (problem.matches_decide && found.pose)
    return {fit_similarity(problem, *found.pose), true, 0, {}};
  if (!found.refined.succeeded || !found.fine) return {};
  const FineSurfaces& fine = *found.fine;
  const SimilarityRefinement refinement(fine.source, fine.target, *fine.near_source,
                                        *fine.near_target, LocalRefinementSettings(),
                                        problem.kernels);
  return refinement({1, *found.pose}, problem.prior.get());
}

void write_similarity(const Problem& problem, const Solution& found, double scale,
                      const SimilarityFit& fit, bool scale_is_exact, Result& result) {
  result.scale = found.pose ? scale : kUnknown;
  for (double& c : result.center_source) c /= scale;
  scale_rotation(scale, result.transformation);
  for (emtr_alternative& other : result.others) scale_rotation(scale, other.transformation);
  if (!fit.succeeded) return;
  if (fit.sums.weights > 0) {
    result.scale_constraint = fit.scale_constraint;
    write_information(fit.sums, fit.similarity.pose.t, found.refined.design_effect,
                      problem.pair.normalization.scale, result.information_similarity);
  }
  if (scale_is_exact) return;
  Similarity similarity = problem.pair.normalization.to_user(fit.similarity);
  similarity.scale *= scale;
  result.scale = similarity.scale;
  to_matrix(similarity, result.transformation);
}

void judge_scale(const SimilarityFit& fit, bool scale_is_exact, const Settings& settings,
                 Result& result) {
  if (!(fit.sums.weights > 0) || result.confidence < settings.minimum_confidence) return;
  if (fit.scale_constraint < kUnconstrainedScale) {
    result.registered = 0;
    result.reason = EMTR_REASON_FREE_SCALE;
  } else if (scale_is_exact && std::abs(std::log(fit.similarity.scale)) > kAnotherScale) {
    result.confidence = lower_for_rival(result.confidence);
    result.scale_factor = fit.similarity.scale;
    result.registered = 0;
    result.reason = EMTR_REASON_SCALE;
  }
}

}  // namespace emtr
