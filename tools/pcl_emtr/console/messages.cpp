#include "console/messages.h"

#include <cmath>
#include <cstdio>

#include "console/colors.h"
#include "console/milliseconds.h"
#include "console/summary.h"

namespace cli {

void Messages::loaded(const CloudFile& cloud) const {
  if (!cloud.note.empty()) warning("'" + cloud.path + "': " + cloud.note);
  if (quiet_) return;
  EMTR_HIGHLIGHT("Loading ");
  EMTR_VALUE("%s ", cloud.path.c_str());
  EMTR_INFO("[done, ");
  EMTR_VALUE("%s", milliseconds(cloud.milliseconds / 1e3).c_str());
  EMTR_INFO(" : ");
  EMTR_VALUE("%zu", cloud.size());
  EMTR_INFO(" points");
  if (cloud.sampled()) EMTR_INFO(" sample the surface of its %zu faces", cloud.faces.size());
  EMTR_INFO("]\n");
}

void Messages::registered(const emtr_result& result, const emtr_settings& settings) const {
  if (!quiet_) print_summary(result, settings);
}

void Messages::verdict(const emtr_result& r) const {
  if (!r.registered)
    warning(std::string("not registered: ") + emtr_reason_text(r.reason) +
            "; the transformation is doubtful");
  if (quiet_) return;
  using namespace pcl::console;
  EMTR_HIGHLIGHT("Verdict ");
  print_color(stderr, TT_BRIGHT, r.registered ? TT_GREEN : TT_RED, "%s",
              r.registered ? "registered" : "not registered");
  if (std::isfinite(r.confidence)) {
    EMTR_INFO(", confidence ");
    EMTR_VALUE("%.3f", r.confidence);
  }
  EMTR_INFO("\n");
  EMTR_HIGHLIGHT("T ");
  if (r.scale == 1)
    EMTR_INFO("(source into target, q = R p + t)\n");
  else
    EMTR_INFO("(source into target, q = s R p + t with s = %.9g)\n", r.scale);
  for (int i = 0; i < 16; i += 4) {
    const double* row = r.transformation + i;
    EMTR_VALUE("  %12.9g %12.9g %12.9g %14.9g\n", row[0], row[1], row[2], row[3]);
  }
}

void Messages::saved(const std::string& path, const std::string& what) const {
  if (quiet_) return;
  EMTR_HIGHLIGHT("Saving ");
  EMTR_VALUE("%s ", path.c_str());
  EMTR_INFO("[done : %s]\n", what.c_str());
}

void Messages::warning(const std::string& text) const {
  using namespace pcl::console;
  print_color(stderr, TT_BRIGHT, TT_YELLOW, "pcl_emtr: warning: %s\n", text.c_str());
}

}  // namespace cli
