#include "report_confidence.h"

namespace cli {

Json alternatives_json(const emtr_result& result) {
  Json out = Json::array();
  for (std::size_t i = 0; i < result.alternative_count; ++i) {
    const emtr_alternative& other = result.alternatives[i];
    out.push_back({{"score", other.score}, {"transformation", rows<4>(other.transformation)}});
  }
  return out;
}

Json refinement_json(const emtr_result& result) {
  if (!result.refined) return Json();
  return {{"information", rows<6>(result.information)},
          {"hessian_eigenvalues", result.hessian_eigenvalues},
          {"hessian_eigenvectors", rows<6>(result.hessian_eigenvectors)},
          {"unconstrained_directions", result.unconstrained_directions}};
}

}  // namespace cli
