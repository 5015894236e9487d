// Gives the readers PCL without loading it, so that a fuzz target is one program.

#include "modules/pcl_module.h"

const cli::PclModule& cli::pcl_module() { return emtr_pcl_module_1; }
