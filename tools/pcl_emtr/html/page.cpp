#include "html/page.h"

#include <cstddef>
#include <string_view>

#include "html/point_block.h"
#include "html/pose_residuals.h"
#include "html/template.h"

namespace cli {
namespace {

constexpr std::size_t kShown = 30000;  // points of each cloud, as in Python
constexpr std::string_view kMark = "@payload@";

/// Returns JSON that can stand in an HTML page: no name ends the script that it is in.
std::string script_text(const Json& json) {
  std::string out;
  for (const char letter : json.dump(-1, ' ', true, Json::error_handler_t::replace)) {
    if (letter == '<')
      out += "\\u003c";
    else
      out += letter;
  }
  return out;
}

/// Returns the direction in the target's frame that is up on the screen.
Json up_of(const emtr_settings& settings) {
  return settings.has_axis ? Json(settings.axis) : Json{0.0, 0.0, 1.0};
}

}  // namespace

std::string html_page(const Options& options, const CloudFile& source, const CloudFile& target,
                      const emtr_result& result, const Json& report) {
  const double radius = result.normalization_scale;
  // The normalized frame's unit is the target's: the source's own is `scale` of it.
  const PointBlock moving =
      point_block(source, result.center_source, radius / result.scale, kShown);
  const PointBlock fixed = point_block(target, result.center_target, radius, kShown);
  const Json payload = {{"format", 1},
                        {"title", ""},
                        {"unit", options.html_unit},
                        {"up", up_of(options.settings)},
                        {"report", report},
                        {"clouds", {{"source", moving.json()}, {"target", fixed.json()}}},
                        {"residuals", pose_residuals(moving.points, target, options, result)}};
  std::string page = html_template();
  return page.replace(page.find(kMark), kMark.size(), script_text(payload));
}

}  // namespace cli
