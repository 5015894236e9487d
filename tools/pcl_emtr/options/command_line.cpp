#include "options/command_line.h"

#include <iostream>
#include <memory>
#include <vector>

#include "align_all/align_options.h"
#include "batch/batch_options.h"
#include "failure.h"
#include "options/file_options.h"
#include "options/help_text.h"
#include "options/preset.h"
#include "options/priors.h"
#include "options/setting_options.h"
#include "options/suggestion.h"
#include "options/viewpoints.h"
#include "text/words.h"
#include "versions.h"

namespace cli {
namespace {

void set_up_help(CLI::App& app) {
  app.formatter(std::make_shared<HelpFormatter>());
  app.get_formatter()->column_width(34);
  app.get_formatter()->label("REQUIRED", "");
  app.footer(help_footer());
  app.set_help_flag("-h,--help", "print the most used options and exit");
  app.set_help_all_flag("--help-all", "print this and exit");
  app.set_version_flag("--version", version_line(), "print the versions and exit");
}

void add_run_options(CLI::App& app, Options& options, bool& reference) {
  app.add_flag("-q,--quiet", options.quiet,
               "print nothing to standard error but errors and warnings");
  app.add_option("--preset", options.preset,
                 wrapped("the settings to begin with: " + preset_names()))
      ->type_name("NAME");
  app.add_flag("--reference", reference,
               wrapped("the slow path to compare with: --neighbors kdtree and --features pcl, so "
                       "that pcl::KdTreeFLANN answers each nearest-neighbor query of the fitness"));
}

std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options())
    for (const auto& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

/// Throws UsageFailure for the first argument that looks like an option and is none.
void require_known_options(const CLI::App& app) {
  for (const std::string& argument : app.remaining()) {
    if (argument.size() < 2 || argument[0] != '-' || argument == "--") continue;
    const std::string name = argument.substr(0, argument.find('='));
    const std::string near = did_you_mean(name, option_names(app));
    throw UsageFailure(name + ": there is no such option" +
                       (near.empty() ? "; see pcl_emtr --help-all" : near));
  }
}

/// Returns false when help or the version was printed instead.
bool parse(CLI::App& app, int argc, char** argv) {
  try {
    app.parse(argc, argv);
    return true;
  } catch (const CLI::CallForHelp&) {
    std::cout << short_help() << std::flush;
  } catch (const CLI::CallForAllHelp&) {
    std::cout << app.help() << std::flush;
  } catch (const CLI::CallForVersion&) {
    std::cout << version_line() << std::endl;
  } catch (const CLI::ParseError& error) {
    // The value of a mistyped option is taken for a cloud, so the option is the first to blame.
    require_known_options(app);
    throw UsageFailure(std::string(error.what()) + "; see pcl_emtr --help");
  }
  return false;
}

}  // namespace

std::optional<Options> parse_command_line(int argc, char** argv) {
  Options options;
  bool reference = false;
  CLI::App app(kDescription, "pcl_emtr");
  set_up_help(app);
  add_run_options(app, options, reference);
  const FileOptions files(app, options);
  const BatchOptions batch(app, options);
  const AlignOptions align(app, options);
  const Viewpoints viewpoints(app);
  const Priors priors(app);
  const SettingOptions settings(app);
  if (!parse(app, argc, argv)) return std::nullopt;
  if (align.check(options)) return options;

  const auto begin = [&](const std::string& preset, emtr_settings& chosen) {
    begin_with_preset(preset, chosen);
    settings.apply(chosen);
    if (reference) settings.use_reference(chosen);
    viewpoints.apply(chosen);
    priors.apply(chosen);
  };
  begin(options.preset, options.settings);
  options.viewpoints_from_files = viewpoints.from_files();
  if (!options.batch.pairs.empty())
    for (const auto& preset : presets()) begin(preset, options.batch.by_preset[preset]);
  batch.check(options);
  files.check(options);
  return options;
}

}  // namespace cli
