#include "write/outputs.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>

#include "failure.h"
#include "interrupt.h"
#include "report/report.h"
#include "write/cloud_output.h"
#include "write/matrix_text.h"
#include "write/moved_cloud.h"
#include "write/output_files.h"
#include "write/residual_field.h"

namespace cli {
namespace {

void print_matrix(const std::string& text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (std::fflush(stdout) != 0 || !written)
    throw Failure(kInputOutput,
                  std::string("standard output cannot be written: ") + std::strerror(errno));
}

}  // namespace

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

}  // namespace cli
