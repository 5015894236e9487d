#include "command_line.h"

#include <iostream>
#include <memory>

#include "failure.h"
#include "file_names.h"
#include "help_text.h"
#include "priors.h"
#include "setting_options.h"
#include "setting_text.h"
#include "versions.h"
#include "viewpoints.h"

namespace cli {
namespace {

std::string preset_names() {
  std::string names;
  for (std::size_t i = 0; emtr_preset_name(i); ++i)
    names += (i == 0                    ? ""
              : emtr_preset_name(i + 1) ? ", "
                                        : " or ") +
             std::string(emtr_preset_name(i));
  return names;
}

void parse(CLI::App& app, int argc, char** argv) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success&) {  // help, version
    throw;
  } catch (const CLI::ParseError& error) {
    throw UsageFailure(std::string(error.what()) + "; see pcl_emtr --help");
  }
}

}  // namespace

std::optional<Options> parse_command_line(int argc, char** argv) {
  Options options;
  CLI::App app(kDescription, "pcl_emtr");
  app.formatter(std::make_shared<HelpFormatter>());
  app.get_formatter()->column_width(34);
  app.get_formatter()->label("REQUIRED", "");
  app.footer(kFooter);
  app.set_help_flag("-h,--help", "print this to standard output and exit");
  app.set_version_flag("--version", version_line(), "print the versions and exit");

  app.add_option("source", options.source, "the cloud to be moved (.pcd, .ply, .obj)")
      ->type_name("FILE")
      ->required();
  app.add_option("target", options.target, "the cloud that stays (.pcd, .ply, .obj)")
      ->type_name("FILE")
      ->required();
  const auto file = [&](const char* name, std::string& path, const std::string& text) {
    return app.add_option(name, path, wrapped(text, 66))->type_name("FILE");
  };
  std::vector<CLI::Option*> outputs = {
      file("-o,--output", options.output,
           "write T here as text, 4 lines of 4 numbers (default: standard output, which then "
           "gets nothing else)"),
      file("--aligned", options.aligned,
           "write the source moved by T here, with all its fields, as binary .pcd or .ply; "
           "normals and the sensor's pose are moved along"),
      file("--report", options.report,
           "write settings, versions, timings, counts, quality, verdict and T here as JSON")};
  CLI::Option* guess = file("--guess", options.guess,
                            "a text file of a 4x4 pose, source into target, to try among others; "
                            "the search does not stay near it, unless --guess-rotation or "
                            "--guess-translation say how near");
  CLI::Option* correspondences =
      file("--correspondences", options.correspondences.path,
           "a text file of matches to take instead of our own: a line for each, the rows of a "
           "source and a target point counted from 0");
  options.fields.add_options(app);
  app.add_option("--preset", options.preset,
                 wrapped("the settings to begin with: " + preset_names(), 66))
      ->type_name("NAME");
  const Viewpoints viewpoints(app);
  app.add_flag("--residuals", options.residuals,
               wrapped("measure the distance of each moved source point to the nearest target "
                       "point: field 'residual' in --aligned, how they spread in --report",
                       66));
  app.add_flag("-q,--quiet", options.quiet,
               "say nothing on standard error but errors and warnings");
  bool reference = false;
  app.add_flag("--reference", reference,
               wrapped("the slow path to compare with: --neighbors kdtree and --features pcl, so "
                       "every look-up of the fitness is one of pcl::KdTreeFLANN",
                       66));
  const Priors priors(app);
  const SettingOptions settings(app);

  try {
    parse(app, argc, argv);
  } catch (const CLI::CallForHelp&) {
    std::cout << app.help() << std::flush;
    return std::nullopt;
  } catch (const CLI::CallForVersion&) {
    std::cout << version_line() << std::endl;
    return std::nullopt;
  }

  if (emtr_settings_init(&options.settings, sizeof options.settings, options.preset.c_str()) !=
      EMTR_OK)
    throw UsageFailure("--preset: '" + options.preset + "' is not one of: " + preset_names());
  settings.apply(options.settings);
  if (reference) settings.use_reference(options.settings);
  viewpoints.apply(options.settings);
  priors.apply(options.settings);
  options.viewpoints_from_files = viewpoints.from_files();

  if (options.residuals && options.aligned.empty() && options.report.empty())
    throw UsageFailure("--residuals: expected --aligned or --report to write them to");
  std::vector<NamedFile> input_files = {{"source", options.source}, {"target", options.target}};
  if (guess->count()) input_files.push_back({"--guess", options.guess});
  if (correspondences->count())
    input_files.push_back({"--correspondences", options.correspondences.path});
  std::vector<NamedFile> output_files;
  for (const CLI::Option* output : outputs)
    if (output->count()) output_files.push_back({output->get_name(), output->as<std::string>()});
  check_file_names(input_files, output_files);
  return options;
}

}  // namespace cli
