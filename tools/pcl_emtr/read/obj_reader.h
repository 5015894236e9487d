#pragma once

#include <pcl/PCLPointCloud2.h>

#include <string>

namespace cli {

/// Reads the vertices of an OBJ file as float x, y, z. Reads its normals also when there is one for
/// each vertex: the i-th belongs to the i-th vertex, whatever the faces say. PCL's own reader
/// crashes on a line of blanks, such as the empty lines of a file from Windows. Returns a note of
/// what was left out of the file, or nothing; throws FileFailure.
std::string read_obj(const std::string& path, pcl::PCLPointCloud2& blob);

}  // namespace cli
