// pcl_emtr: global registration of two point cloud files by EMTR-SSC.

#if __has_include(<malloc.h>)
#include <malloc.h>
#endif
#include <pcl/console/print.h>

#include <cstdio>
#include <exception>
#include <new>

#include "console/terminal.h"
#include "failure.h"
#include "run.h"

namespace {

/// Lets freed memory serve the next stage. Else the kernel takes back each larger array, and clears
/// pages for the next one, which is a twentieth of the time.
void keep_freed_memory() {
#ifdef __GLIBC__
  mallopt(M_MMAP_THRESHOLD, 32 << 20);  // the largest that glibc takes
  mallopt(M_TRIM_THRESHOLD, 64 << 20);
  mallopt(M_TOP_PAD, 64 << 20);
#endif
}

}  // namespace

int main(int argc, char** argv) {
  keep_freed_memory();
  // PCL's readers print a lot to standard error; a Failure tells in one line what is wrong.
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  cli::choose_colors();
  try {
    return cli::run(argc, argv);
  } catch (const cli::Failure& failure) {
    std::fprintf(stderr, "pcl_emtr: error: %s\n", failure.what());
    return failure.code;
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "pcl_emtr: error: not enough memory\n");
    return cli::kInputOutput;
  } catch (const std::exception& error) {  // from the file system, for example
    std::fprintf(stderr, "pcl_emtr: error: %s\n", error.what());
    return cli::kInputOutput;
  }
}
