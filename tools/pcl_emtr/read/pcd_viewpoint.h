#pragma once

#include "read/cloud_file.h"

namespace cli {

/// Sets the sensor's pose from the line VIEWPOINT in full precision: PCL's reader keeps floats,
/// which are too short for map coordinates. Leaves out a pose that is not finite, with a note.
void read_pcd_viewpoint(CloudFile& cloud);

}  // namespace cli
