// In place of load_pcl_module.cpp where the module is a part of the program.

#include "modules/pcl_module.h"

const cli::PclModule& cli::pcl_module() { return emtr_pcl_module_1; }
