#include "report/report_costs.h"

#include <vector>

namespace cli {
namespace {

Json counts_json(const CloudFile& source, const CloudFile& target, const emtr_result& r) {
  return {{"read_source", source.size()},
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
}

Json seconds_json(const CloudFile& source, const CloudFile& target, const emtr_result& r) {
  return {{"load_source", source.milliseconds / 1e3},
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
}

}  // namespace

void add_costs(Json& out, const CloudFile& source, const CloudFile& target, const emtr_result& r) {
  out["counts"] = counts_json(source, target, r);
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
  out["seconds"] = seconds_json(source, target, r);
  out["history"] = {{"alpha", std::vector<double>(r.history_alpha, r.history_alpha + r.iterations)},
                    {"beta", std::vector<double>(r.history_beta, r.history_beta + r.iterations)}};
}

}  // namespace cli
