// pcl_emtr: global registration of two point cloud files by EMTR-SSC.

#include <fcntl.h>
#include <pcl/console/print.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>
#include <vector>

#include "cloud_output.h"
#include "command_line.h"
#include "failure.h"
#include "interrupt.h"
#include "matrix_text.h"
#include "moved_cloud.h"
#include "output_files.h"
#include "registration.h"
#include "report.h"
#include "residuals.h"
#include "talk.h"
#include "viewpoints.h"

namespace cli {
namespace {

/// Whatever can be known before the long computation.
void check_before(Options& options) {
  require_cloud_file(options.source);
  require_cloud_file(options.target);
  if (!options.guess.empty()) {
    read_matrix(options.guess, options.settings.guess);
    options.settings.has_guess = 1;
  }
  if (!options.correspondences.path.empty()) {
    options.correspondences = read_correspondences(options.correspondences.path);
    options.settings.correspondences = options.correspondences.pairs.data();
    options.settings.correspondence_count = options.correspondences.size();
  }
  for (const auto* path : {&options.output, &options.aligned, &options.report})
    if (!path->empty()) OutputFiles::require_writable(*path);
  if (options.output.empty() && fcntl(STDOUT_FILENO, F_GETFL) < 0)
    throw Failure(kInputOutput, "standard output is closed, and there is no -o for the matrix");
}

void print_matrix(const std::string& text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (std::fflush(stdout) != 0 || !written)
    throw Failure(kInputOutput,
                  std::string("standard output cannot be written: ") + std::strerror(errno));
}

void write_outputs(const Options& options, CloudFile& source, const CloudFile& target,
                   const emtr_result& result, const std::vector<double>& residuals) {
  ignore_interrupts();
  OutputFiles files;
  const std::string matrix = matrix_text(result.transformation);
  if (!options.output.empty()) files.write_text(options.output, matrix);
  if (!options.report.empty())
    files.write_text(options.report, report(options, source, target, result, residuals));
  if (!options.aligned.empty()) {
    using RowMajor = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;
    move_cloud(source, Eigen::Map<const RowMajor>(result.transformation));
    if (options.residuals) set_residuals(source, residuals);
    files.write(options.aligned, [&](const std::string& temporary) {
      write_cloud(source, options.aligned, temporary);
    });
  }
  if (options.output.empty()) print_matrix(matrix);
  files.commit();
}

int run(int argc, char** argv) {
  auto parsed = parse_command_line(argc, argv);
  if (!parsed) return kRegistered;
  Options& options = *parsed;
  const Talk talk(options.quiet);
  check_before(options);

  CloudFile source = load_cloud(options.source);
  talk.loaded(source);
  if (!options.aligned.empty()) require_writable_as(options.aligned, source);
  if (options.residuals && !options.aligned.empty()) require_place_for_residuals(source);
  CloudFile target = load_cloud(options.target);
  talk.loaded(target);
  emtr_settings& settings = options.settings;
  settle_viewpoint(source, options.viewpoints_from_files, settings.has_viewpoint_source,
                   settings.viewpoint_source);
  settle_viewpoint(target, options.viewpoints_from_files, settings.has_viewpoint_target,
                   settings.viewpoint_target);

  const Result result = run_registration(source, target, options);
  talk.registered(*result, settings);
  talk.verdict(*result);
  std::vector<double> residuals;
  if (options.residuals) residuals = measure_residuals(source, target, options, *result);
  write_outputs(options, source, target, *result, residuals);
  if (!options.output.empty()) talk.saved(options.output, "4x4 matrix");
  if (!options.aligned.empty())
    talk.saved(options.aligned, std::to_string(source.size()) + " points");
  if (!options.report.empty()) talk.saved(options.report, "report");
  return exit_code(*result);
}

}  // namespace
}  // namespace cli

int main(int argc, char** argv) {
  // PCL's readers talk to standard error at length; what is wrong is said in one line below.
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  try {
    return cli::run(argc, argv);
  } catch (const cli::Failure& failure) {
    std::fprintf(stderr, "pcl_emtr: error: %s\n", failure.what());
    return failure.code;
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "pcl_emtr: error: not enough memory\n");
    return cli::kInputOutput;
  } catch (const std::exception& error) {  // of the file system, say
    std::fprintf(stderr, "pcl_emtr: error: %s\n", error.what());
    return cli::kInputOutput;
  }
}
