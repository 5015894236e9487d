#include "options/file_options.h"

#include <string>

#include "failure.h"
#include "formats/format.h"
#include "options/file_formats.h"
#include "options/file_names.h"
#include "options/stream_names.h"
#include "text/words.h"

namespace cli {
namespace {

constexpr char kUserData[] = "User-provided data";
constexpr char kFormats[] = "Formats and meshes";

/// Adds an option for a file; `dash` is the path that is meant by "-".
CLI::Option* add_file(CLI::App& app, const std::string& name, std::string& path,
                      const std::string& text, const std::string& dash) {
  const auto meant = [dash](const std::string& given) { return given == "-" ? dash : given; };
  return app.add_option(name, path, wrapped(text))->transform(meant)->type_name("FILE");
}

CLI::Option* add_input(CLI::App& app, const std::string& name, std::string& path,
                       const std::string& text) {
  return add_file(app, name, path, text, "/dev/stdin");
}

CLI::Option* add_output(CLI::App& app, const std::string& name, std::string& path,
                        const std::string& text) {
  return add_file(app, name, path, text, "/dev/stdout");
}

std::vector<NamedFile> named(const std::vector<CLI::Option*>& options) {
  std::vector<NamedFile> files;
  for (const CLI::Option* option : options)
    if (option->count()) files.push_back({option->get_name(), option->as<std::string>()});
  return files;
}

}  // namespace

FileOptions::FileOptions(CLI::App& app, Options& options) {
  inputs_ = {add_input(app, "source", options.source,
                       "the cloud to move: " + read_extensions() +
                           ", also with .gz behind it; - is standard input"),
             add_input(app, "target", options.target, "the cloud that stays")};
  for (CLI::Option* cloud : inputs_) cloud->required();
  add_outputs(app, options);
  add_user_data(app, options);
  add_formats(app, options);
}

void FileOptions::add_outputs(CLI::App& app, Options& options) {
  outputs_ = {
      add_output(app, "-o,--output", options.output,
                 "write T here as text, 4 lines of 4 numbers (default: standard output, which then "
                 "gets nothing else)"),
      add_output(
          app, "--aligned", options.aligned,
          "write the source moved by T here, with all its fields, as " + written_extensions() +
              " (PCD and PLY are binary); normals, the sensor's pose and the faces of a mesh are "
              "moved too, but a PCD file gets the points that sample a mesh"),
      add_output(app, "--report", options.report,
                 "write settings, versions, timings, counts, quality, verdict and T here as JSON"),
      add_output(
          app, "--html", options.html,
          "write a page to look at here: both clouds in three dimensions, the error map, the "
          "verdict and what to try, the alternatives, timings and settings; one file for a "
          "browser, which loads nothing; with --batch and --align-all this is a folder, for the "
          "pages of all pairs and an index.html, made by the Python package")};
  for (CLI::Option* output : outputs_) output->group("Output files");
  app.add_option("--html-unit", options.html_unit,
                 wrapped("the name of the clouds' unit, for the scale bar of --html, such as mm"))
      ->type_name("NAME")
      ->group("Output files");
  app.add_flag("--residuals", options.residuals,
               wrapped("measure the distance of each moved source point to the nearest target "
                       "point: field 'residual' in --aligned, their distribution in --report"))
      ->group("Output files");
}

void FileOptions::add_user_data(CLI::App& app, Options& options) {
  inputs_.push_back(
      add_input(app, "--guess", options.guess,
                "a text file of a 4x4 pose, source into target, to try among others; the search "
                "does not stay near it, unless --guess-rotation or --guess-translation say how "
                "near")
          ->group(kUserData));
  inputs_.push_back(
      add_input(
          app, "--correspondences", options.correspondences.path,
          "a text file of correspondences to use instead of matching features: each line has the "
          "number of a source point and of a target point, counted from 0")
          ->group(kUserData));
  app.add_flag("--use-normals", options.fields.normals,
               wrapped("use the fields normal_x, normal_y, normal_z of both files, as "
                       "pcl_normal_estimation writes them, instead of estimating normals"))
      ->group(kUserData);
  app.add_flag("--use-features{fpfh}", options.fields.features,
               wrapped("match points by this field of both files, an array of floats, instead of "
                       "computing features; the default is fpfh, as pcl_fpfh_estimation writes "
                       "it; --use-features=shot names another field"))
      ->group(kUserData);
}

void FileOptions::add_formats(CLI::App& app, Options& options) {
  app.add_option(
         "--mesh-points", mesh_points_,
         wrapped("how many points sample the surface of a mesh, evenly; 0 takes its vertices "
                 "[from 0 to 100000000; default 100000, or 0 where user-provided data belong "
                 "to the vertices]"))
      ->type_name("N")
      ->group(kFormats);
  app.add_option(
         "--input-format", options.input_format,
         wrapped("read both clouds as this format, whatever their names say [" + read_extensions() +
                 "; default by the extension, or of a stream without one "
                 "by its beginning]"))
      ->type_name("NAME")
      ->group(kFormats);
  app.add_option("--aligned-format", options.aligned_format,
                 wrapped("write --aligned in this format [" + written_extensions() +
                         "; default by the extension, or of a stream without one as the source]"))
      ->type_name("NAME")
      ->group(kFormats);
}

void FileOptions::check(Options& options) const {
  if (options.residuals && options.aligned.empty() && options.report.empty())
    throw UsageFailure("--residuals: expected --aligned or --report to write them to");
  if (!options.html_unit.empty() && options.html.empty())
    throw UsageFailure("--html-unit: expected --html, on whose page it is shown");
  check_formats(options);
  options.mesh_points = mesh_points(mesh_points_, options);
  const auto inputs = named(inputs_), outputs = named(outputs_);
  check_file_names(inputs, outputs, options.aligned_format);
  check_streams(inputs, outputs, options.output.empty());
}

}  // namespace cli
