#include "mesh/sample_mesh.h"

#include <cmath>
#include <utility>
#include <vector>

#include "mesh/surface_sampling.h"
#include "read/blob.h"
#include "read/coordinates.h"
#include "read/vector_field.h"

namespace cli {
namespace {

std::size_t vertices_in_faces(const CloudFile& cloud) {
  std::vector<bool> found(cloud.size());
  std::size_t count = 0;
  for (const auto corner : cloud.faces.corners) {
    count += !found[corner];
    found[corner] = true;
  }
  return count;
}

std::vector<Eigen::Vector3d> positions(const CloudFile& cloud) {
  const VectorField field = require_vector(cloud, {"x", "y", "z"});
  std::vector<Eigen::Vector3d> out(cloud.size());
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] = field.get(cloud.blob.data.data() + i * cloud.blob.point_step);
  return out;
}

void drop_faces(CloudFile& cloud, const std::string& why) {
  cloud.add_note("its " + std::to_string(cloud.faces.size()) + " faces are left out, " + why);
  cloud.faces = Faces();
}

}  // namespace

void sample_mesh(CloudFile& cloud, std::size_t points) {
  if (cloud.faces.empty()) return;
  const std::size_t used = vertices_in_faces(cloud);
  if (2 * used < cloud.size()) return drop_faces(cloud, "most of its vertices are in none");
  if (points == 0) return;
  const std::vector<Eigen::Vector3d> vertices = positions(cloud);
  const SurfaceSampling surface(vertices, cloud.faces);
  if (!(surface.area() > 0) || !std::isfinite(surface.area()))
    return drop_faces(cloud, "they have no area");
  auto blob = doubles_blob({"x", "y", "z"});
  reserve_points(blob, points);
  for (const auto& point : surface.points(points)) add_point(blob, point.data());
  finish_blob(blob, cloud.path, "a surface");
  cloud.vertices = std::exchange(cloud.blob, std::move(blob));
}

void take_vertices(CloudFile& cloud) {
  if (cloud.sampled()) cloud.blob = std::exchange(cloud.vertices, pcl::PCLPointCloud2());
}

}  // namespace cli
