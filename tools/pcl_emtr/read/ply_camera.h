#pragma once

#include "read/cloud_file.h"

namespace cli {

/// Sets the sensor's pose from the element "camera" that PCL writes into a PLY file (view_p* and
/// the rows x_axis*, y_axis*, z_axis* of the rotation), and that PCL's own reader skips
/// before 1.15. Leaves the pose unchanged when the file has no camera, or has it behind a list.
void read_ply_camera(CloudFile& cloud);

}  // namespace cli
