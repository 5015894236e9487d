#include "run.h"

#include <fcntl.h>
#include <unistd.h>

#include <string>
#include <vector>

#include "align_all/align_all.h"
#include "batch/batch.h"
#include "console/messages.h"
#include "failure.h"
#include "options/command_line.h"
#include "options/file_formats.h"
#include "read/cloud_path.h"
#include "read/matrix_file.h"
#include "registration.h"
#include "report/residuals.h"
#include "report/unit_hint.h"
#include "write/cloud_output.h"
#include "write/output_files.h"
#include "write/outputs.h"
#include "write/residual_field.h"

namespace cli {
namespace {

/// Reads the small files, and throws on every fault that can be known before the long computation.
void check_before(Options& options) {
  require_cloud_file(options.source, options.input_format);
  require_cloud_file(options.target, options.input_format);
  if (!options.guess.empty()) {
    read_matrix(options.guess, options.settings.guess);
    options.settings.has_guess = 1;
  }
  if (!options.correspondences.path.empty()) {
    options.correspondences = read_correspondences(options.correspondences.path);
    options.settings.correspondences = options.correspondences.pairs.data();
    options.settings.correspondence_count = options.correspondences.size();
  }
  for (const auto* path : {&options.output, &options.aligned, &options.report, &options.html})
    if (!path->empty()) OutputFiles::require_writable(*path);
  if (options.output.empty() && fcntl(STDOUT_FILENO, F_GETFL) < 0)
    throw Failure(kInputOutput, "standard output is closed, and there is no -o for the matrix");
}

/// Makes a cloud and its setting agree on where the sensor stood. A position that the user gave
/// becomes the cloud's, so that it moves with the cloud; else the file's becomes the setting, if
/// `from_file`.
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

/// Says what --aligned has, once it is written.
std::string saved_text(const CloudFile& source, const Format& format) {
  const bool mesh = format.with_faces && !source.faces.empty();
  return std::to_string(source.size()) +
         (mesh ? " vertices, " + std::to_string(source.faces.size()) + " faces" : " points");
}

}  // namespace

int run(int argc, char** argv) {
  auto parsed = parse_command_line(argc, argv);
  if (!parsed) return kRegistered;
  Options& options = *parsed;
  if (!options.align.scans.empty()) run_align_all(options);
  if (!options.batch.pairs.empty()) return run_batch(options);
  const Messages messages(options.quiet);
  check_before(options);

  CloudFile source = load_cloud(options.source, options.mesh_points, options.input_format);
  messages.loaded(source);
  options.aligned_as = aligned_format(options, source);
  if (options.aligned_as) require_writable_as(options.aligned, *options.aligned_as, source);
  if (options.aligned_as && options.residuals)
    require_place_for_residuals(source, *options.aligned_as);
  CloudFile target = load_cloud(options.target, options.mesh_points, options.input_format);
  messages.loaded(target);
  emtr_settings& settings = options.settings;
  settle_viewpoint(source, options.viewpoints_from_files, settings.has_viewpoint_source,
                   settings.viewpoint_source);
  settle_viewpoint(target, options.viewpoints_from_files, settings.has_viewpoint_target,
                   settings.viewpoint_target);

  const Result result = run_registration(source, target, options);
  messages.registered(*result, settings);
  messages.verdict(*result);
  const UnitHint hint = result->registered ? UnitHint() : unit_hint(source, target);
  if (!hint.text.empty()) messages.warning(hint.text);
  std::vector<double> residuals;
  if (options.residuals) residuals = measure_residuals(source, target, options, *result);
  write_outputs(options, source, target, *result, residuals, hint);
  if (!options.output.empty()) messages.saved(options.output, "4x4 matrix");
  if (options.aligned_as) messages.saved(options.aligned, saved_text(source, *options.aligned_as));
  if (!options.report.empty()) messages.saved(options.report, "report");
  if (!options.html.empty()) messages.saved(options.html, "page");
  return exit_code(*result);
}

}  // namespace cli
