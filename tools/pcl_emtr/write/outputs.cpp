#include "write/outputs.h"

#include <csignal>
#include <string>

#include "html/page.h"
#include "interrupt.h"
#include "mesh/sample_mesh.h"
#include "report/report.h"
#include "report/residuals.h"
#include "write/cloud_output.h"
#include "write/matrix_text.h"
#include "write/moved_cloud.h"
#include "write/output_files.h"
#include "write/residual_field.h"

namespace cli {
namespace {

constexpr char kStandardOutput[] = "/dev/stdout";

/// Moves the source and writes it: the vertices and faces of a mesh where the format has faces,
/// else the points that were registered.
void write_aligned(const Options& options, CloudFile& source, const CloudFile& target,
                   const emtr_result& result, std::vector<double> residuals, OutputFiles& files) {
  if (source.sampled() && options.aligned_as->with_faces) {
    take_vertices(source);
    if (options.residuals) residuals = measure_residuals(source, target, options, result);
  }
  using RowMajor = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;
  move_cloud(source, Eigen::Map<const RowMajor>(result.transformation), result.scale);
  if (options.residuals) set_residuals(source, residuals);
  files.write(options.aligned, [&](const std::string& temporary) {
    write_cloud(source, *options.aligned_as, options.aligned, temporary);
  });
}

}  // namespace

void write_outputs(const Options& options, CloudFile& source, const CloudFile& target,
                   const emtr_result& result, const std::vector<double>& residuals,
                   const UnitHint& hint) {
  const Interrupt interrupt(Interrupt::kEndsCalls);
  std::signal(SIGPIPE, SIG_IGN);  // a reader who leaves is an error of writing
  OutputFiles files;
  const std::string matrix = matrix_text(result.transformation);
  files.write_text(options.output.empty() ? kStandardOutput : options.output, matrix);
  const Json told = report(options, source, target, result, residuals, hint);
  if (!options.report.empty()) files.write_text(options.report, report_text(told));
  if (!options.html.empty())
    files.write_text(options.html, html_page(options, source, target, result, told));
  if (!options.aligned.empty()) write_aligned(options, source, target, result, residuals, files);
  files.commit();
}

}  // namespace cli
