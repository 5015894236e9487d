#pragma once

#include <pcl/PCLPointCloud2.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "files/spool.h"
#include "formats/format.h"
#include "mesh/faces.h"

namespace cli {

/// A cloud as its file has it: every field, and the pose of the sensor that took it.
struct CloudFile {
  std::string path;   // as the user named it, for messages
  std::string place;  // where its bytes are: another path for a stream or a compressed file
  std::shared_ptr<Spool> spool;  // has the bytes of these two
  const Format* format = nullptr;
  pcl::PCLPointCloud2 blob;
  Faces faces;  // of the rows of `blob`, or of `vertices` of a mesh that was sampled; or none
  pcl::PCLPointCloud2 vertices;  // of a mesh whose surface is sampled by the points of `blob`
  Eigen::Vector3d sensor_origin = Eigen::Vector3d::Zero();
  Eigen::Quaterniond sensor_orientation = Eigen::Quaterniond::Identity();
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();  // by which it has been moved
  bool sensor_known = false;  // the file has a pose other than the default of its format
  std::string note;           // what was left out of the file, or empty
  double milliseconds = 0;    // spent on reading it

  std::size_t size() const { return std::size_t{blob.width} * blob.height; }
  bool sampled() const { return !vertices.data.empty(); }

  /// Returns the fields that the file has for each point or vertex.
  const std::vector<pcl::PCLPointField>& file_fields() const {
    return sampled() ? vertices.fields : blob.fields;
  }

  /// Adds one sentence to the note.
  void add_note(const std::string& text) { note += (note.empty() ? "" : "; ") + text; }
};

/// Reads a cloud in any format of formats(); throws FileFailure on whatever is wrong with the file.
/// The surface of a mesh is sampled by `mesh_points` points, or 0: its vertices are taken. `format`
/// is the one that the user named, or empty.
CloudFile load_cloud(const std::string& path, std::size_t mesh_points = 0,
                     const std::string& format = "");

}  // namespace cli
