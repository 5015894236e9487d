#include "talk.h"

#include <pcl/console/print.h>
#include <unistd.h>

#include <chrono>
#include <cinttypes>
#include <cstdio>
#include <string>

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

void counts(const char* name, std::size_t points, std::size_t dropped, std::size_t sparse,
            std::size_t dense) {
  INFO("  %s ", name);
  VALUE("%zu", points);
  INFO(" finite points, ");
  VALUE("%zu", dropped);
  INFO(" dropped (NaN or infinite); ");
  if (sparse) INFO("sparse %zu, ", sparse);
  INFO("dense %zu\n", dense);
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

void Talk::registered(const emtr_result& r) const {
  if (quiet_) return;
  HIGHLIGHT("Registering ");
  INFO("[done, ");
  VALUE("%s", ms(r.seconds_total).c_str());
  INFO(" : ");
  VALUE("%zu", r.iterations);
  INFO(" iterations]\n");
  INFO("  frame %s, densities %s, features %s, matching %s, evolution %s, verdict %s\n",
       ms(r.seconds_frame).c_str(), ms(r.seconds_densities).c_str(), ms(r.seconds_features).c_str(),
       ms(r.seconds_matching).c_str(), ms(r.seconds_evolution).c_str(),
       ms(r.seconds_verdict).c_str());
  counts("source", r.points_source, r.dropped_source, r.sparse_source, r.dense_source);
  counts("target", r.points_target, r.dropped_target, 0, r.dense_target);
  INFO("  %zu correspondences, %zu TIMs (%zu pruned), %" PRIu64 " look-ups, %d threads, %s\n",
       r.correspondences, r.tims, r.tims_pruned,
       r.lookups_evaluation + r.lookups_switch + r.lookups_complement, r.threads, r.kernel);
  INFO("  fitness ");
  VALUE("%.4f", r.fitness);
  INFO(" (0 is best), inliers ");
  VALUE("%.1f", 100 * r.inlier_ratio_source);
  INFO(" %% of source, ");
  VALUE("%.1f", 100 * r.inlier_ratio_target);
  INFO(" %% of target, their rmse ");
  VALUE("%.4g", r.inlier_rmse);
  INFO(", gap to the next best pose ");
  VALUE("%.4f\n", r.mode_gap);
}

void Talk::verdict(const emtr_result& r) const {
  if (!r.registered)
    warning(std::string("not registered: ") + emtr_reason_text(r.reason) +
            "; the transformation is doubtful");
  if (quiet_) return;
  HIGHLIGHT("Verdict ");
  print_color(stderr, TT_BRIGHT, r.registered ? TT_GREEN : TT_RED, "%s\n",
              r.registered ? "registered" : "not registered");
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

ProgressLine::ProgressLine(bool quiet) : active_(!quiet && isatty(STDERR_FILENO)) {}

ProgressLine::~ProgressLine() {
  if (active_ && last_ >= 0) std::fputs("\r\033[K", stderr);
}

void ProgressLine::show(const emtr_progress& progress) {
  if (!active_) return;
  const double now =
      std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  const bool first = progress.iteration == 0;  // of a stage, always shown
  if (!first && now - last_ < 0.05) return;
  last_ = now;
  std::fprintf(stderr, "\r\033[K%s", progress.stage);
  if (!first)
    std::fprintf(stderr, " %d/%d  best alpha %.5g  best beta %.5g", progress.iteration,
                 progress.iterations, progress.best_alpha, progress.best_beta);
  std::fflush(stderr);
}

}  // namespace cli
