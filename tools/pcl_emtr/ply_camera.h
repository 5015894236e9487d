#pragma once

#include "cloud_file.h"

namespace cli {

/// Fills in the sensor pose from the element "camera" that PCL writes into a PLY file
/// (view_p* and the rows x_axis*, y_axis*, z_axis* of the rotation), which its reader of 1.13
/// passes over. Leaves the pose alone when the file has none, or has it behind a list.
void read_ply_camera(CloudFile& cloud);

}  // namespace cli
