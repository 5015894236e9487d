#include "batch/read_cloud.h"

#include <vector>

#include "failure.h"
#include "read/cloud_file.h"
#include "read/color_fields.h"
#include "read/coordinates.h"

namespace cli {
namespace {

constexpr char kPrefix[] = "cloud: ";  // of the library's messages

std::size_t bytes_of(const emtr_preprocessed_info& info) {
  const std::size_t points = info.base_points * (info.normals ? 24 : 12);
  const std::size_t features = info.keypoints * (4 * info.feature_dimension + 24);
  const bool some_left_out = info.dropped || info.strays;
  return points + features + (some_left_out ? 8 * info.points : 0);
}

}  // namespace

std::shared_ptr<const ReadCloud> read_cloud(const std::string& path, std::size_t mesh_points,
                                            const Options& options) {
  const CloudFile file = load_cloud(path, mesh_points, options.input_format);
  std::vector<double> copy, normals;
  emtr_cloud points = coordinates(file, copy);
  options.fields.attach(file, points, normals);
  ColorFields colors;
  attach_colors(file, points, colors);
  auto cloud = std::make_shared<ReadCloud>();
  emtr_preprocessed* raw = nullptr;
  if (emtr_preprocess(&points, nullptr, 1, &raw) != EMTR_OK) {
    const std::string message = emtr_error_message();
    const bool prefixed = message.compare(0, sizeof kPrefix - 1, kPrefix) == 0;
    throw FileFailure(path, prefixed ? message.substr(sizeof kPrefix - 1) : message);
  }
  cloud->preprocessed.reset(raw);
  emtr_preprocessed_info info;
  emtr_preprocessed_describe(raw, &info, sizeof info);
  cloud->bytes = bytes_of(info);
  if (points.colors || points.intensities) cloud->bytes += 12 * info.base_points;
  cloud->sensor_origin = file.sensor_origin;
  cloud->sensor_known = file.sensor_known;
  cloud->note = file.note;
  return cloud;
}

}  // namespace cli
