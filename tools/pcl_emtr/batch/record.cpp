#include "batch/record.h"

#include "report/report_input.h"
#include "report/result_json.h"

namespace cli {
namespace {

Json heading(const Pair& pair, const char* status) {
  return {{"index", pair.index},        {"name", text_or_null(pair.name)},
          {"source", pair.source_text}, {"target", pair.target_text},
          {"status", status},           {"error", Json()}};
}

/// Returns the text of a JSON value as it is read back from a file.
std::string text(const Json& value) {
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

Json result_record(const Pair& pair, const emtr_settings& settings, const emtr_result& result) {
  Json out = heading(pair, result.registered ? "registered" : "not_registered");
  add_settings(out, pair.settings->preset, settings);
  out["mesh_points"] = pair.settings->mesh_points;
  add_result(out, result);
  out["reason_text"] = emtr_reason_text(result.reason);
  return out;
}

Json error_record(const Pair& pair, const std::string& error) {
  Json out = heading(pair, "error");
  out["error"] = error;
  return out;
}

std::string record_line(const Json& record) { return text(record) + "\n"; }

std::string record_difference(const Json& record, const Pair& pair, bool any_viewpoints) {
  const auto differs = [&](const Json& found, const Json& wanted, const std::string& name) {
    return text(found) == text(wanted)
               ? ""
               : "has the " + name + " " + text(found) + ", and the pair has " + text(wanted);
  };
  const Json here = heading(pair, "");
  for (const char* name : {"name", "source", "target"})
    if (auto found = differs(record.at(name), here[name], name); !found.empty()) return found;
  if (record.at("status") == "error") return "";
  Json wanted;
  add_settings(wanted, pair.settings->preset, pair.settings->settings);
  wanted["mesh_points"] = pair.settings->mesh_points;
  for (const auto& [name, value] : wanted.items()) {
    if (name == "settings") {
      for (const auto& [setting, number] : value.items())
        if (setting != "threads")
          if (auto found = differs(record.at(name).value(setting, Json()), number, setting);
              !found.empty())
            return found;
    } else if (name != "viewpoints" || !any_viewpoints) {
      if (auto found = differs(record.at(name), value, name); !found.empty()) return found;
    }
  }
  return "";
}

}  // namespace cli
