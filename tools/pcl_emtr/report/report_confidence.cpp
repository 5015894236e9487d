#include "report/report_confidence.h"

namespace cli {

void add_verdict(Json& out, const emtr_result& r) {
  out["registered"] = r.registered != 0;
  out["reason"] = emtr_reason_name(r.reason);
  out["reason_text"] = emtr_reason_text(r.reason);
  out["confidence"] = r.confidence;
  out["transformation"] = rows<4>(r.transformation);
}

Json quality_json(const emtr_result& r) {
  return {{"fitness", r.fitness},
          {"inlier_ratio_source", r.inlier_ratio_source},
          {"inlier_ratio_target", r.inlier_ratio_target},
          {"fitness_gap", r.fitness_gap},
          {"overlap_source", r.overlap_source},
          {"overlap_target", r.overlap_target},
          {"inlier_rmse", r.inlier_rmse},
          {"inlier_rmse_plane", r.inlier_rmse_plane},
          {"score", r.score},
          {"surface_fit", r.surface_fit},
          {"violation", r.violation},
          {"score_gap", r.score_gap}};
}

Json alternatives_json(const emtr_result& r) {
  Json out = Json::array();
  for (std::size_t i = 0; i < r.alternative_count; ++i) {
    const emtr_alternative& other = r.alternatives[i];
    out.push_back({{"score", other.score}, {"transformation", rows<4>(other.transformation)}});
  }
  return out;
}

Json refinement_json(const emtr_result& r) {
  if (!r.refined) return Json();
  return {{"information", rows<6>(r.information)},
          {"hessian_eigenvalues", r.hessian_eigenvalues},
          {"hessian_eigenvectors", rows<6>(r.hessian_eigenvectors)},
          {"unconstrained_directions", r.unconstrained_directions}};
}

}  // namespace cli
