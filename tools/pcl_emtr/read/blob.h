#pragma once

#include <pcl/PCLPointCloud2.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace cli {

// How a reader of our own builds a cloud.

/// Adds a field of one value of the type, as pcl::PCLPointField numbers it, behind the others.
void add_field(pcl::PCLPointCloud2& blob, const std::string& name, std::uint8_t type);

/// Returns a cloud of these fields, all of doubles, and no points.
pcl::PCLPointCloud2 doubles_blob(const std::vector<std::string>& names);

/// Makes room for the points, so that adding them does not take twice the memory.
void reserve_points(pcl::PCLPointCloud2& blob, std::size_t points);

/// Adds the fields of the next point, as many as the cloud has.
void add_point(pcl::PCLPointCloud2& blob, const double* values);

/// Counts the points. Throws FileFailure about `path` when there are none, or more than PCL can
/// count; `expected` says what a point would have looked like.
void finish_blob(pcl::PCLPointCloud2& blob, const std::string& path, const std::string& expected);

}  // namespace cli
