#include "talk.h"

#include <pcl/console/print.h>

#include <cinttypes>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

namespace cli {
namespace {

using pcl::console::print_color;
using pcl::console::TT_BRIGHT;
using pcl::console::TT_CYAN;
using pcl::console::TT_GREEN;
using pcl::console::TT_RED;
using pcl::console::TT_RESET;
using pcl::console::TT_WHITE;
using pcl::console::TT_YELLOW;

// The three colours of PCL's print_highlight, print_value and print_info, whose own functions
// write to standard output.
#define HIGHLIGHT(...)                                     \
  do {                                                     \
    print_color(stderr, TT_BRIGHT, TT_GREEN, "> ");        \
    print_color(stderr, TT_BRIGHT, TT_WHITE, __VA_ARGS__); \
  } while (false)
#define VALUE(...) print_color(stderr, TT_RESET, TT_CYAN, __VA_ARGS__)
#define INFO(...) print_color(stderr, TT_RESET, TT_WHITE, __VA_ARGS__)

std::string ms(double seconds) {
  char text[32];
  const double value = 1e3 * seconds;
  std::snprintf(text, sizeof text, value < 100 ? "%.3g ms" : "%.0f ms", value);
  return text;
}

/// Milliseconds of the stages that took any.
std::string stages(const emtr_result& r) {
  const std::pair<const char*, double> all[] = {
      {"normalization", r.seconds_normalization},           {"downsampling", r.seconds_downsampling},
      {"features", r.seconds_features},     {"matching", r.seconds_matching},
      {"seeds", r.seconds_seeds},           {"evolution", r.seconds_evolution},
      {"candidates", r.seconds_candidates}, {"fallback_search", r.seconds_fallback_search},
      {"refinement", r.seconds_refinement}, {"verdict", r.seconds_verdict}};
  std::string text;
  for (const auto& [name, seconds] : all) {
    if (seconds == 0) continue;
    char number[32];
    std::snprintf(number, sizeof number, " %.*f", seconds < 0.01 ? 1 : 0, 1e3 * seconds);
    text += (text.empty() ? "" : ", ") + std::string(name) + number;
  }
  return text;
}

void counts(const char* name, std::size_t points, std::size_t dropped, std::size_t sparse,
            std::size_t dense, const double* viewpoint) {
  INFO("  %s ", name);
  VALUE("%zu", points);
  INFO(" finite points, ");
  VALUE("%zu", dropped);
  INFO(" dropped (NaN or infinite); ");
  if (sparse) INFO("sparse %zu, ", sparse);
  INFO("dense %zu", dense);
  if (viewpoint) INFO("; sensor at %.7g %.7g %.7g", viewpoint[0], viewpoint[1], viewpoint[2]);
  INFO("\n");
}

}  // namespace

void Talk::loaded(const CloudFile& cloud) const {
  if (!cloud.note.empty()) warning("'" + cloud.path + "': " + cloud.note);
  if (quiet_) return;
  HIGHLIGHT("Loading ");
  VALUE("%s ", cloud.path.c_str());
  INFO("[done, ");
  VALUE("%s", ms(cloud.milliseconds / 1e3).c_str());
  INFO(" : ");
  VALUE("%zu", cloud.size());
  INFO(" points]\n");
}

void Talk::registered(const emtr_result& r, const emtr_settings& settings) const {
  if (quiet_) return;
  HIGHLIGHT("Registering ");
  INFO("[done, ");
  VALUE("%s", ms(r.seconds_total).c_str());
  INFO(" : ");
  VALUE("%zu", r.iterations);
  INFO(" iterations%s%s]\n", r.used_fallback_search ? ", used_fallback_search" : "", r.refined ? ", refined" : "");
  INFO("  ms: %s\n", stages(r).c_str());
  counts("source", r.points_source, r.dropped_source, r.sparse_source, r.dense_source,
         settings.has_viewpoint_source ? settings.viewpoint_source : nullptr);
  counts("target", r.points_target, r.dropped_target, 0, r.dense_target,
         settings.has_viewpoint_target ? settings.viewpoint_target : nullptr);
  INFO("  %zu correspondences", r.correspondences);
  if (r.correspondences < r.correspondences_found) INFO(" of %zu", r.correspondences_found);
  INFO(", %zu TIMs (%zu pruned), ", r.tims, r.tims_pruned);
  if (r.seeds) INFO("%zu %s, ", r.seeds, r.seeds == 1 ? "seed" : "seeds");
  if (r.candidates) INFO("%zu %s, ", r.candidates, r.candidates == 1 ? "candidate" : "candidates");
  INFO("%" PRIu64 " look-ups, %d threads, %s\n",
       r.queries_evaluation + r.queries_switch + r.queries_complement, r.threads, r.kernel);
  INFO("  fitness ");
  VALUE("%.4f", r.fitness);
  INFO(" (0 is best), inliers ");
  VALUE("%.1f", 100 * r.inlier_ratio_source);
  INFO(" %% of source, ");
  VALUE("%.1f", 100 * r.inlier_ratio_target);
  INFO(" %% of target");
  standing(r);
  INFO("  overlap ");
  VALUE("%.1f", 100 * r.overlap_source);
  INFO(" %% of source, ");
  VALUE("%.1f", 100 * r.overlap_target);
  INFO(" %% of target, its rmse ");
  VALUE("%.4g", r.inlier_rmse);
  INFO(" to points, ");
  VALUE("%.4g", r.inlier_rmse_plane);
  INFO(" to planes\n");
}

void Talk::standing(const emtr_result& r) const {
  if (!r.candidates) {  // the swarm alone
    INFO(", gap to the next best pose ");
    VALUE("%.4f\n", r.fitness_gap);
    return;
  }
  INFO("\n  surfaces: fit ");
  VALUE("%.4f", r.surface_fit);
  INFO(" (1 is best), violation ");
  VALUE("%.4f", r.violation);
  INFO(" (0 is best), score ");
  VALUE("%.4f", r.score);
  if (r.alternative_count) {
    INFO(", next best pose ");
    VALUE("%.4f", r.alternatives[0].score);
  }
  INFO("\n");
}

void Talk::verdict(const emtr_result& r) const {
  if (!r.registered)
    warning(std::string("not registered: ") + emtr_reason_text(r.reason) +
            "; the transformation is doubtful");
  if (quiet_) return;
  HIGHLIGHT("Verdict ");
  print_color(stderr, TT_BRIGHT, r.registered ? TT_GREEN : TT_RED, "%s",
              r.registered ? "registered" : "not registered");
  if (std::isfinite(r.confidence)) {
    INFO(", confidence ");
    VALUE("%.3f", r.confidence);
  }
  INFO("\n");
  HIGHLIGHT("T ");
  INFO("(source into target, q = R p + t)\n");
  for (int i = 0; i < 16; i += 4) {
    const double* row = r.transformation + i;
    VALUE("  %12.9g %12.9g %12.9g %14.9g\n", row[0], row[1], row[2], row[3]);
  }
}

void Talk::saved(const std::string& path, const std::string& what) const {
  if (quiet_) return;
  HIGHLIGHT("Saving ");
  VALUE("%s ", path.c_str());
  INFO("[done : %s]\n", what.c_str());
}

void Talk::warning(const std::string& text) const {
  print_color(stderr, TT_BRIGHT, TT_YELLOW, "pcl_emtr: warning: %s\n", text.c_str());
}

}  // namespace cli
