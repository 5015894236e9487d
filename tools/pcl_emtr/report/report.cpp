#include "report/report.h"

#include "report/json.h"
#include "report/report_input.h"
#include "report/residuals.h"
#include "report/result_json.h"

namespace cli {

std::string report(const Options& options, const CloudFile& source, const CloudFile& target,
                   const emtr_result& r, const std::vector<double>& residuals) {
  Json out;
  add_input(out, options);
  add_result(out, r);
  out["reason_text"] = emtr_reason_text(r.reason);
  out["residuals"] = options.residuals ? residuals_json(residuals) : Json();
  out["counts"]["read_source"] = source.size();
  out["counts"]["read_target"] = target.size();
  out["seconds"]["load_source"] = source.milliseconds / 1e3;
  out["seconds"]["load_target"] = target.milliseconds / 1e3;
  // A file name need not be UTF-8: its odd bytes are replaced rather than the report lost.
  return out.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace cli
