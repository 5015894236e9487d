#include "report/report_input.h"

#include "options/setting_text.h"
#include "versions.h"

namespace cli {
namespace {

Json setting_json(const emtr_setting_info& info, double value) {
  switch (info.type) {
    case EMTR_SETTING_SWITCH:
      return value != 0;
    case EMTR_SETTING_INTEGER:
      return static_cast<std::int64_t>(value);
    case EMTR_SETTING_CHOICE:
      return choices_of(info).at(static_cast<std::size_t>(value));
    case EMTR_SETTING_REAL:
      break;
  }
  return value;
}

Json settings_json(const emtr_settings& settings) {
  Json out;
  for (std::size_t i = 0; i < emtr_setting_count(); ++i) {
    emtr_setting_info info;
    emtr_setting_describe(i, &info, sizeof info);
    double value = 0;
    emtr_setting_get(&settings, info.name, &value);
    out[info.name] = setting_json(info, value);
  }
  out["seed"] = settings.seed;  // all 64 bits
  return out;
}

Json vector_or_null(std::int32_t known, const double (&vector)[3]) {
  return known ? Json(vector) : Json();
}

void add_known_pose(Json& out, const emtr_settings& s) {
  out["guess"] = s.has_guess ? rows<4>(s.guess) : Json();
  out["viewpoints"] = {{"source", vector_or_null(s.has_viewpoint_source, s.viewpoint_source)},
                       {"target", vector_or_null(s.has_viewpoint_target, s.viewpoint_target)}};
  out["axis"] = vector_or_null(s.has_axis, s.axis);
  out["translation_bounds"] =
      s.has_translation_bounds ? Json{s.translation_minimum, s.translation_maximum} : Json();
}

}  // namespace

void add_settings(Json& out, const std::string& preset, const emtr_settings& settings) {
  out["preset"] = preset;
  out["settings"] = settings_json(settings);
  add_known_pose(out, settings);
}

void add_input(Json& out, const Options& options) {
  out["versions"] = {
      {"emtr", emtr_version()}, {"pcl", PCL_VERSION_PRETTY}, {"eigen", eigen_version()}};
  out["files"] = {{"source", options.source},
                  {"target", options.target},
                  {"transformation", text_or_null(options.output)},
                  {"aligned", text_or_null(options.aligned)},
                  {"report", text_or_null(options.report)},
                  {"html", text_or_null(options.html)},
                  {"guess", text_or_null(options.guess)},
                  {"correspondences", text_or_null(options.correspondences.path)}};
  add_settings(out, options.preset, options.settings);
  out["user_provided"] = {{"normals", options.fields.normals},
                          {"features", text_or_null(options.fields.features)},
                          {"correspondences", options.correspondences.size()}};
}

}  // namespace cli
