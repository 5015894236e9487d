// Files of a 4x4 matrix, as pcl_emtr --guess reads them.
#include <string>

#include "failure.h"
#include "input.h"
#include "matrix_text.h"
#include "scratch_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::Scratch scratch;
  double matrix[16], again[16];
  try {
    cli::read_matrix(scratch.file("in.txt", data, size), matrix);
  } catch (const cli::FileFailure&) {
    return 0;
  }
  // What is read can be written, and is the same when read again.
  const std::string text = cli::matrix_text(matrix);
  cli::read_matrix(
      scratch.file("out.txt", reinterpret_cast<const std::uint8_t*>(text.data()), text.size()),
      again);
  fuzz::require(std::memcmp(matrix, again, sizeof matrix) == 0);
  return 0;
}
