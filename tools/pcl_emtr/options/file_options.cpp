#include "options/file_options.h"

#include <string>

#include "failure.h"
#include "options/file_names.h"
#include "text/words.h"

namespace cli {
namespace {

constexpr char kUserData[] = "User-provided data";

CLI::Option* add_file(CLI::App& app, const std::string& name, std::string& path,
                      const std::string& text) {
  return app.add_option(name, path, wrapped(text))->type_name("FILE");
}

std::vector<NamedFile> named(const std::vector<CLI::Option*>& options) {
  std::vector<NamedFile> files;
  for (const CLI::Option* option : options)
    if (option->count()) files.push_back({option->get_name(), option->as<std::string>()});
  return files;
}

}  // namespace

FileOptions::FileOptions(CLI::App& app, Options& options) {
  inputs_ = {add_file(app, "source", options.source, "the cloud to move (.pcd, .ply, .obj)"),
             add_file(app, "target", options.target, "the cloud that stays (.pcd, .ply, .obj)")};
  for (CLI::Option* cloud : inputs_) cloud->required();
  add_outputs(app, options);
  add_user_data(app, options);
}

void FileOptions::add_outputs(CLI::App& app, Options& options) {
  outputs_ = {
      add_file(app, "-o,--output", options.output,
               "write T here as text, 4 lines of 4 numbers (default: standard output, which then "
               "gets nothing else)"),
      add_file(app, "--aligned", options.aligned,
               "write the source moved by T here, with all its fields, as binary .pcd or .ply; "
               "normals and the sensor's pose are moved too"),
      add_file(app, "--report", options.report,
               "write settings, versions, timings, counts, quality, verdict and T here as JSON")};
  for (CLI::Option* output : outputs_) output->group("Output files");
  app.add_flag("--residuals", options.residuals,
               wrapped("measure the distance of each moved source point to the nearest target "
                       "point: field 'residual' in --aligned, their distribution in --report"))
      ->group("Output files");
}

void FileOptions::add_user_data(CLI::App& app, Options& options) {
  inputs_.push_back(
      add_file(app, "--guess", options.guess,
               "a text file of a 4x4 pose, source into target, to try among others; the search "
               "does not stay near it, unless --guess-rotation or --guess-translation say how "
               "near")
          ->group(kUserData));
  inputs_.push_back(
      add_file(
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

void FileOptions::check(const Options& options) const {
  if (options.residuals && options.aligned.empty() && options.report.empty())
    throw UsageFailure("--residuals: expected --aligned or --report to write them to");
  check_file_names(named(inputs_), named(outputs_));
}

}  // namespace cli
