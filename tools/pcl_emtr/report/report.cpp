#include "report/report.h"

#include "report/json.h"
#include "report/report_input.h"
#include "report/residuals.h"
#include "report/result_json.h"

namespace cli {
namespace {

Json hint_json(const UnitHint& hint) {
  if (hint.text.empty()) return Json();
  return {{"ratio", hint.ratio}, {"factor", hint.factor}, {"text", hint.text}};
}

/// Returns what a mesh had, and how many points sample it: 0 when its vertices are the points.
Json mesh_json(const CloudFile& cloud) {
  if (cloud.faces.empty()) return Json();
  const bool sampled = cloud.sampled();
  const std::size_t vertices =
      sampled ? std::size_t{cloud.vertices.width} * cloud.vertices.height : cloud.size();
  return {{"vertices", vertices},
          {"faces", cloud.faces.size()},
          {"sampled_points", sampled ? cloud.size() : 0}};
}

}  // namespace

Json report(const Options& options, const CloudFile& source, const CloudFile& target,
            const emtr_result& r, const std::vector<double>& residuals, const UnitHint& hint) {
  Json out;
  add_input(out, options);
  add_result(out, r);
  out["reason_text"] = emtr_reason_text(r.reason);
  out["residuals"] = options.residuals ? residuals_json(residuals) : Json();
  out["unit_hint"] = hint_json(hint);
  out["meshes"] = {{"source", mesh_json(source)}, {"target", mesh_json(target)}};
  out["counts"]["read_source"] = source.size();
  out["counts"]["read_target"] = target.size();
  out["seconds"]["load_source"] = source.milliseconds / 1e3;
  out["seconds"]["load_target"] = target.milliseconds / 1e3;
  return out;
}

std::string report_text(const Json& report) {
  // A file name need not be UTF-8: its odd bytes are replaced rather than the report lost.
  return report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace cli
