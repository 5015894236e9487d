#include "report/report.h"

#include "report/json.h"
#include "report/report_confidence.h"
#include "report/report_costs.h"
#include "report/report_input.h"
#include "report/residuals.h"

namespace cli {

std::string report(const Options& options, const CloudFile& source, const CloudFile& target,
                   const emtr_result& r, const std::vector<double>& residuals) {
  Json out;
  add_input(out, options, r);
  add_verdict(out, r);
  out["quality"] = quality_json(r);
  out["used_fallback_search"] = r.used_fallback_search != 0;
  out["refined"] = r.refined != 0;
  out["alternatives"] = alternatives_json(r);
  out["refinement"] = refinement_json(r);
  out["residuals"] = options.residuals ? residuals_json(residuals) : Json();
  add_costs(out, source, target, r);
  // A file name need not be UTF-8: its odd bytes are replaced rather than the report lost.
  return out.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace cli
