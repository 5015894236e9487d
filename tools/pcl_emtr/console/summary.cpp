#include "console/summary.h"

#include <cinttypes>
#include <cstdio>
#include <cstring>
#include <string>

#include "console/colors.h"
#include "console/milliseconds.h"

namespace cli {
namespace {

/// Returns the milliseconds of the stages that took any.
std::string stages(const emtr_result& result) {
  std::string text;
  for (std::size_t i = 0; i < emtr_result_field_count(); ++i) {
    emtr_result_field_info field;
    emtr_result_field_describe(i, &field, sizeof field);
    const std::string group = field.group, stage = field.key;
    if (group != "seconds" || stage == "total") continue;
    double seconds;
    std::memcpy(&seconds, reinterpret_cast<const char*>(&result) + field.offset, sizeof seconds);
    if (seconds == 0) continue;
    char number[32];
    std::snprintf(number, sizeof number, " %.*f", seconds < 0.01 ? 1 : 0, 1e3 * seconds);
    text += (text.empty() ? "" : ", ") + stage + number;
  }
  return text;
}

void print_cloud(const char* name, std::size_t points, std::size_t dropped, std::size_t strays,
                 std::size_t sparse, std::size_t dense, const double* viewpoint) {
  EMTR_INFO("  %s ", name);
  EMTR_VALUE("%zu", points);
  EMTR_INFO(" finite points, ");
  EMTR_VALUE("%zu", dropped);
  EMTR_INFO(" dropped (NaN or infinite)");
  if (strays) EMTR_INFO(", %zu %s left out", strays, strays == 1 ? "stray" : "strays");
  EMTR_INFO("; ");
  if (sparse) EMTR_INFO("sparse %zu, ", sparse);
  EMTR_INFO("dense %zu", dense);
  if (viewpoint) EMTR_INFO("; sensor at %.7g %.7g %.7g", viewpoint[0], viewpoint[1], viewpoint[2]);
  EMTR_INFO("\n");
}

void print_search(const emtr_result& r) {
  EMTR_INFO("  %zu correspondences", r.correspondences);
  if (r.correspondences < r.correspondences_found) EMTR_INFO(" of %zu", r.correspondences_found);
  EMTR_INFO(", %zu TIMs (%zu pruned), ", r.tims, r.tims_pruned);
  if (r.seeds) EMTR_INFO("%zu %s, ", r.seeds, r.seeds == 1 ? "seed" : "seeds");
  if (r.candidates)
    EMTR_INFO("%zu %s, ", r.candidates, r.candidates == 1 ? "candidate" : "candidates");
  EMTR_INFO("%" PRIu64 " nearest-neighbor queries, %d threads, %s\n",
            r.queries_evaluation + r.queries_switch + r.queries_complement, r.threads, r.kernel);
}

void print_fitness(const emtr_result& r) {
  EMTR_INFO("  fitness ");
  EMTR_VALUE("%.4f", r.fitness);
  EMTR_INFO(" (0 is best), inliers ");
  EMTR_VALUE("%.1f", 100 * r.inlier_ratio_source);
  EMTR_INFO(" %% of source, ");
  EMTR_VALUE("%.1f", 100 * r.inlier_ratio_target);
  EMTR_INFO(" %% of target");
  if (!r.candidates) {  // the swarm's best is the answer
    EMTR_INFO(", gap to the next best pose ");
    EMTR_VALUE("%.4f", r.fitness_gap);
  }
  EMTR_INFO("\n");
}

void print_surfaces(const emtr_result& r) {
  EMTR_INFO("  surfaces: fit ");
  EMTR_VALUE("%.4f", r.surface_fit);
  EMTR_INFO(" (1 is best), violation ");
  EMTR_VALUE("%.4f", r.violation);
  EMTR_INFO(" (0 is best), score ");
  EMTR_VALUE("%.4f", r.score);
  if (r.alternative_count) {
    EMTR_INFO(", next best pose ");
    EMTR_VALUE("%.4f", r.alternatives[0].score);
  }
  EMTR_INFO("\n");
}

void print_overlap(const emtr_result& r) {
  EMTR_INFO("  overlap ");
  EMTR_VALUE("%.1f", 100 * r.overlap_source);
  EMTR_INFO(" %% of source, ");
  EMTR_VALUE("%.1f", 100 * r.overlap_target);
  EMTR_INFO(" %% of target, its rmse ");
  EMTR_VALUE("%.4g", r.inlier_rmse);
  EMTR_INFO(" to points, ");
  EMTR_VALUE("%.4g", r.inlier_rmse_plane);
  EMTR_INFO(" to planes\n");
}

}  // namespace

void print_summary(const emtr_result& r, const emtr_settings& settings) {
  EMTR_HIGHLIGHT("Registering ");
  EMTR_INFO("[done, ");
  EMTR_VALUE("%s", milliseconds(r.seconds_total).c_str());
  EMTR_INFO(" : ");
  EMTR_VALUE("%zu", r.iterations);
  EMTR_INFO(" iterations%s%s]\n", r.used_fallback_search ? ", fallback search" : "",
            r.refined ? ", refined" : "");
  EMTR_INFO("  ms: %s\n", stages(r).c_str());
  print_cloud("source", r.points_source, r.dropped_source, r.strays_source, r.sparse_source,
              r.dense_source, settings.has_viewpoint_source ? settings.viewpoint_source : nullptr);
  print_cloud("target", r.points_target, r.dropped_target, r.strays_target, 0, r.dense_target,
              settings.has_viewpoint_target ? settings.viewpoint_target : nullptr);
  print_search(r);
  print_fitness(r);
  if (r.candidates) print_surfaces(r);
  print_overlap(r);
}

}  // namespace cli
