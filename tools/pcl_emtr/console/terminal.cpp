#include "console/terminal.h"

#include <pcl/console/print.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace cli {

bool is_dumb_terminal() {
  const char* terminal = std::getenv("TERM");
  return terminal && std::strcmp(terminal, "dumb") == 0;
}

void choose_colors() {
  const char* no_color = std::getenv("NO_COLOR");
  if (is_dumb_terminal() || (no_color && *no_color))
    pcl::console::enableColoredOutput(stderr, false);
}

}  // namespace cli
