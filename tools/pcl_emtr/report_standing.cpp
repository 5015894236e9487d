#include "report_standing.h"

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
          {"hold", result.hold},
          {"hold_directions", rows<6>(result.hold_directions)},
          {"free_directions", result.free_directions}};
}

}  // namespace cli
