#include "options/viewpoints.h"

#include "failure.h"
#include "options/suggestion.h"
#include "text/words.h"

namespace cli {
namespace {

constexpr char kGroup[] = "Viewpoints";

void read(const NumbersOption<3>& given, std::int32_t& known, double (&position)[3]) {
  if (!given.given()) return;
  for (std::size_t i = 0; i < 3; ++i) position[i] = given[i];
  known = 1;
}

}  // namespace

Viewpoints::Viewpoints(CLI::App& app) {
  const auto add = [&](const std::string& cloud, NumbersOption<3>& position) {
    const std::string text = "where the " + cloud + "'s sensor stood, in the coordinates of the " +
                             cloud + "; helps where little overlaps";
    position.option = app.add_option("--viewpoint-" + cloud, position.words, wrapped(text));
    position.option->type_name("X Y Z")->group(kGroup);
  };
  add("source", source_);
  add("target", target_);
  app.add_option("--viewpoint", from_,
                 wrapped("where the other positions come from: file (VIEWPOINT of PCD, camera of "
                         "PLY; 0 0 0 1 0 0 0 means unknown) or none [default file]"))
      ->type_name("file|none")
      ->group(kGroup);
}

void Viewpoints::apply(emtr_settings& settings) const {
  read(source_, settings.has_viewpoint_source, settings.viewpoint_source);
  read(target_, settings.has_viewpoint_target, settings.viewpoint_target);
  if (from_ == "file" || from_ == "none") return;
  const std::string near = did_you_mean(from_, {"file", "none"});
  throw UsageFailure("--viewpoint: '" + from_ + "' is not file or none" +
                     (near.empty() ? "; a position is given by --viewpoint-source X Y Z or "
                                     "--viewpoint-target X Y Z"
                                   : near));
}

}  // namespace cli
