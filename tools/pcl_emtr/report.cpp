#include "report.h"

#include "json_rows.h"
#include "report_confidence.h"
#include "residuals.h"
#include "setting_text.h"
#include "versions.h"

namespace cli {
namespace {

Json file_name(const std::string& path) { return path.empty() ? Json() : Json(path); }

Json position(std::int32_t known, const double (&at)[3]) { return known ? Json(at) : Json(); }

Json settings_json(const emtr_settings& settings) {
  Json out;
  for (std::size_t i = 0; i < emtr_setting_count(); ++i) {
    emtr_setting_info info;
    emtr_setting_describe(i, &info, sizeof info);
    double value = 0;
    emtr_setting_get(&settings, info.name, &value);
    switch (info.type) {
      case EMTR_SETTING_SWITCH:
        out[info.name] = value != 0;
        break;
      case EMTR_SETTING_INTEGER:
        out[info.name] = static_cast<std::int64_t>(value);
        break;
      case EMTR_SETTING_REAL:
        out[info.name] = value;
        break;
      case EMTR_SETTING_CHOICE:
        out[info.name] = choices_of(info).at(static_cast<std::size_t>(value));
        break;
    }
  }
  out["seed"] = settings.seed;  // all 64 bits
  return out;
}

}  // namespace

std::string report(const Options& options, const CloudFile& source, const CloudFile& target,
                   const emtr_result& r, const std::vector<double>& residuals) {
  Json out;
  out["versions"] = {
      {"emtr", emtr_version()}, {"pcl", PCL_VERSION_PRETTY}, {"eigen", eigen_version()}};
  out["files"] = {{"source", options.source},
                  {"target", options.target},
                  {"transformation", file_name(options.output)},
                  {"aligned", file_name(options.aligned)},
                  {"report", options.report},
                  {"guess", file_name(options.guess)},
                  {"correspondences", file_name(options.correspondences.path)}};
  out["preset"] = options.preset;
  out["seed"] = r.seed;
  out["threads"] = r.threads;
  out["kernel"] = r.kernel;
  out["settings"] = settings_json(options.settings);
  const emtr_settings& s = options.settings;
  out["guess"] = s.has_guess ? rows<4>(s.guess) : Json();
  out["viewpoints"] = {{"source", position(s.has_viewpoint_source, s.viewpoint_source)},
                       {"target", position(s.has_viewpoint_target, s.viewpoint_target)}};
  out["axis"] = position(s.has_axis, s.axis);
  out["translation_bounds"] =
      s.has_translation_bounds ? Json{s.translation_minimum, s.translation_maximum} : Json();

  out["user_provided"] = {{"normals", options.fields.normals},
                      {"features", file_name(options.fields.features)},
                      {"correspondences", options.correspondences.size()}};

  out["registered"] = r.registered != 0;
  out["reason"] = emtr_reason_name(r.reason);
  out["reason_text"] = emtr_reason_text(r.reason);
  out["confidence"] = r.confidence;
  out["transformation"] = rows<4>(r.transformation);
  out["quality"] = {{"fitness", r.fitness},
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
  out["used_fallback_search"] = r.used_fallback_search != 0;
  out["refined"] = r.refined != 0;
  out["alternatives"] = alternatives_json(r);
  out["refinement"] = refinement_json(r);
  out["residuals"] = options.residuals ? residuals_json(residuals) : Json();
  out["counts"] = {{"read_source", source.size()},
                   {"read_target", target.size()},
                   {"points_source", r.points_source},
                   {"points_target", r.points_target},
                   {"dropped_source", r.dropped_source},
                   {"dropped_target", r.dropped_target},
                   {"sparse_source", r.sparse_source},
                   {"sparse_target", r.sparse_target},
                   {"dense_source", r.dense_source},
                   {"dense_target", r.dense_target},
                   {"correspondences", r.correspondences},
                   {"correspondences_found", r.correspondences_found},
                   {"tims", r.tims},
                   {"tims_pruned", r.tims_pruned},
                   {"seeds", r.seeds},
                   {"candidates", r.candidates},
                   {"iterations", r.iterations}};
  out["queries"] = {{"evaluation", r.queries_evaluation},
                    {"switch", r.queries_switch},
                    {"complement", r.queries_complement},
                    {"total", r.queries_evaluation + r.queries_switch + r.queries_complement}};
  out["normalization"] = {{"normalization_scale", r.normalization_scale},
                  {"center_source", r.center_source},
                  {"center_target", r.center_target},
                  {"leaf_sparse", r.leaf_sparse},
                  {"leaf_dense", r.leaf_dense},
                  {"leaf_fine", r.leaf_fine}};
  out["seconds"] = {{"load_source", source.milliseconds / 1e3},
                    {"load_target", target.milliseconds / 1e3},
                    {"normalization", r.seconds_normalization},
                    {"downsampling", r.seconds_downsampling},
                    {"features", r.seconds_features},
                    {"matching", r.seconds_matching},
                    {"seeds", r.seconds_seeds},
                    {"evolution", r.seconds_evolution},
                    {"candidates", r.seconds_candidates},
                    {"fallback_search", r.seconds_fallback_search},
                    {"refinement", r.seconds_refinement},
                    {"verdict", r.seconds_verdict},
                    {"total", r.seconds_total}};
  out["history"] = {{"alpha", std::vector<double>(r.history_alpha, r.history_alpha + r.iterations)},
                    {"beta", std::vector<double>(r.history_beta, r.history_beta + r.iterations)}};
  // A file name need not be UTF-8; its odd bytes are replaced rather than the report lost.
  return out.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace cli
