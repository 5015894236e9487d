#include "viewpoints.h"

#include <cmath>

#include "failure.h"
#include "numbers.h"
#include "setting_text.h"

namespace cli {

Viewpoints::Viewpoints(CLI::App& app) {
  const auto add = [&](const std::string& cloud, Entry& entry) {
    const std::string text = "where the " + cloud + "'s sensor stood, in the " + cloud +
                             "'s own frame and unit; helps where little overlaps";
    entry.option = app.add_option("--viewpoint-" + cloud, entry.words, wrapped(text, 66));
    entry.option->type_name("X Y Z");
  };
  add("source", source_);
  add("target", target_);
  app.add_option(
         "--viewpoint", from_,
         wrapped("where positions come from that are not given: file (VIEWPOINT of PCD, camera "
                 "of PLY; 0 0 0 1 0 0 0 means unknown) or none [default file]",
                 66))
      ->type_name("file|none");
}

void Viewpoints::apply(emtr_settings& settings) const {
  const auto read = [](const Entry& entry, std::int32_t& known, double(&position)[3]) {
    if (entry.option->count() == 0) return;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto value = parse_real(entry.words[i]);
      if (!value || !std::isfinite(*value))
        throw UsageFailure(entry.option->get_name() + ": '" + entry.words[i] +
                           "' is not a finite number, expected X Y Z");
      position[i] = *value;
    }
    known = 1;
  };
  read(source_, settings.has_viewpoint_source, settings.viewpoint_source);
  read(target_, settings.has_viewpoint_target, settings.viewpoint_target);
  if (from_ != "file" && from_ != "none")
    throw UsageFailure("--viewpoint: '" + from_ +
                       "' is not file or none; a position is given by --viewpoint-source X Y Z "
                       "or --viewpoint-target X Y Z");
}

void settle_viewpoint(CloudFile& cloud, bool from_file, std::int32_t& known,
                      double (&position)[3]) {
  if (known) {
    cloud.sensor_origin = Eigen::Vector3d::Map(position);
    cloud.sensor_known = true;
  } else if (from_file && cloud.sensor_known) {
    Eigen::Vector3d::Map(position) = cloud.sensor_origin;
    known = 1;
  }
}

}  // namespace cli
