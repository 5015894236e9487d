#pragma once

#include <emtr/emtr.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <string>
#include <vector>

#include "calls.h"
#include "failure.h"
#include "formats/format.h"
#include "mesh/sample_mesh.h"
#include "read/cloud_file.h"
#include "read/coordinates.h"
#include "scratch_file.h"
#include "write/cloud_output.h"
#include "write/moved_cloud.h"

namespace fuzz {

/// Writes the cloud as --aligned does, and requires that it is complete when it is read again.
inline void write_and_read(const cli::CloudFile& cloud, const std::string& path) {
  try {
    const cli::Format& format = *cli::format_of(path);
    cli::require_writable_as(path, format, cloud);
    cli::write_cloud(cloud, format, path, path);
  } catch (const cli::FileFailure&) {
    return;  // PLY and OBJ cannot hold all fields that PCD can, nor PCL's writer odd names of
             // colors
  }
  try {
    require(cli::load_cloud(path).size() == cloud.size());
  } catch (const cli::FileFailure& failure) {
    // Now and then the fuzzer makes points whose bytes spell a line of a header.
    require(std::string(failure.what()).find("its points begin with a line") != std::string::npos);
  }
}

/// Reads a file of these bytes as pcl_emtr does. It may refuse the file by a FileFailure and by
/// nothing else; what it reads is used as the command uses it.
inline void read_cloud(const std::string& extension, const std::uint8_t* data, std::size_t size) {
  static const Scratch scratch;
  const std::string path = scratch.file("in" + extension, data, size);
  cli::CloudFile cloud;
  try {
    cloud = cli::load_cloud(path);
  } catch (const cli::FileFailure&) {
    return;
  }
  std::vector<double> copy;
  const emtr_cloud points = cli::coordinates(cloud, copy);
  require(points.count == cloud.size() && points.count > 0);
  emtr_preprocessed* preprocessed = nullptr;
  accepted(emtr_preprocess(&points, "", 1, &preprocessed));
  emtr_preprocessed_free(preprocessed);

  const Eigen::Matrix4d quarter_rotation =
      (Eigen::Translation3d(1, 2, 3) * Eigen::AngleAxisd(M_PI_2, Eigen::Vector3d::UnitZ()))
          .matrix();
  cli::move_cloud(cloud, quarter_rotation, 1);
  write_and_read(cloud, scratch.path("out.pcd"));
  write_and_read(cloud, scratch.path("out.ply"));
  write_and_read(cloud, scratch.path("out.obj"));

  // The surface of a mesh, unless it is none; its vertices come back whole.
  cli::CloudFile mesh = cli::load_cloud(path, 20);
  require(mesh.sampled() ? mesh.size() == 20 : mesh.size() == cloud.size());
  cli::take_vertices(mesh);
  require(mesh.size() == cloud.size());
}

}  // namespace fuzz
