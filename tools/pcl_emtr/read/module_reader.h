#pragma once

#include "read/cloud_file.h"

namespace cli {

// Read a file by a module: a library beside the command that is loaded when such a file is read, so
// that nobody else waits for the libraries behind it. Throw FileFailure, which names the CMake
// option and the package when the command was built without the module.

void read_las(CloudFile& cloud);
void read_e57(CloudFile& cloud);

}  // namespace cli
