// pcl_emtr: global registration of two point cloud files by EMTR-SSC.

#include <pcl/console/print.h>

#include <cstdio>
#include <exception>
#include <new>

#include "console/terminal.h"
#include "failure.h"
#include "run.h"

int main(int argc, char** argv) {
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
