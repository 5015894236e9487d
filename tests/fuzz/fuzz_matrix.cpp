// Fuzzes files of a 4x4 matrix, as pcl_emtr --guess reads them.
#include <cstddef>
#include <string>

#include "failure.h"
#include "input.h"
#include "read/matrix_file.h"
#include "scratch_file.h"
#include "write/matrix_text.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::Scratch scratch;
  double matrix[16], again[16];
  try {
    cli::read_matrix(scratch.file("in.txt", data, size), matrix);
  } catch (const cli::FileFailure&) {
    return 0;
  }
  // The matrix is the same when it is written and read again.
  const std::string text = cli::matrix_text(matrix);
  cli::read_matrix(
      scratch.file("out.txt", reinterpret_cast<const std::uint8_t*>(text.data()), text.size()),
      again);
  fuzz::require(std::memcmp(matrix, again, sizeof matrix) == 0);
  return 0;
}
