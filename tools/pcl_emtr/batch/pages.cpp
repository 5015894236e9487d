#include "batch/pages.h"

#include <string>

#include "failure.h"
#include "python/python_package.h"

namespace cli {

void require_pages(const Options& options) {
  if (!options.html.empty() && !python_has_pyemtr())
    throw Failure(kInputOutput,
                  "--html with --batch: the pages are made by the Python package pyemtr, which "
                  "python3 does not have; install it: pip install 'pyemtr[files]'");
}

int make_pages(const Options& options) {
  const BatchInput& batch = options.batch;
  return run_python({"-m", "pyemtr.batch", "--out", batch.out, "--html", options.html, "--workers",
                     std::to_string(batch.workers), "--cache-memory",
                     std::to_string(batch.cache_bytes >> 20), "--", batch.pairs});
}

}  // namespace cli
