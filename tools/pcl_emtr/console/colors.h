#pragma once

#include <pcl/console/print.h>

// Print to standard error in the three colors of PCL's print_highlight, print_value and print_info,
// whose own functions write to standard output.

#define EMTR_HIGHLIGHT(...)                                                                   \
  do {                                                                                        \
    pcl::console::print_color(stderr, pcl::console::TT_BRIGHT, pcl::console::TT_GREEN, "> "); \
    pcl::console::print_color(stderr, pcl::console::TT_BRIGHT, pcl::console::TT_WHITE,        \
                              __VA_ARGS__);                                                   \
  } while (false)
#define EMTR_VALUE(...) \
  pcl::console::print_color(stderr, pcl::console::TT_RESET, pcl::console::TT_CYAN, __VA_ARGS__)
#define EMTR_INFO(...) \
  pcl::console::print_color(stderr, pcl::console::TT_RESET, pcl::console::TT_WHITE, __VA_ARGS__)
