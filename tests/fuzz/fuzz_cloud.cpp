// Fuzzes how the library takes one cloud: reading, validation, normalization.
#include <emtr/emtr.h>

#include <memory>
#include <string>

#include "any_cloud.h"
#include "calls.h"
#include "input.h"

namespace {

using fuzz::accepted;
using fuzz::require;

void preprocess(const emtr_cloud& cloud, const std::string& name) {
  emtr_preprocessed* preprocessed = nullptr;
  if (!accepted(emtr_preprocess(&cloud, name.c_str(), 1, &preprocessed))) {
    require(preprocessed == nullptr);
    return;
  }
  const std::unique_ptr<emtr_preprocessed, decltype(&emtr_preprocessed_free)> owned(
      preprocessed, emtr_preprocessed_free);
  emtr_preprocessed_info info;
  require(accepted(emtr_preprocessed_describe(preprocessed, &info, sizeof info)));
  require(info.points + info.dropped == cloud.count && info.points >= (cloud.keep_points ? 3 : 10));
  require(info.base_points + info.strays == info.points);  // too few to be downsampled
  require(std::isfinite(info.radius) && info.radius > 0);
  for (const double value : info.center) require(std::isfinite(value));
  require(info.normals == (cloud.normals != nullptr));
  require(info.feature_dimension == cloud.feature_dimension && info.keypoints <= info.points);
  require((info.keypoints > 0) == (cloud.features != nullptr));
}

/// Makes a view contradict itself.
emtr_cloud contradiction(emtr_cloud cloud, fuzz::Input& input) {
  const std::size_t packed = cloud.scalar == EMTR_FLOAT32 ? 12 : 24;
  const auto within = [&](std::size_t low, std::size_t high) {
    return input.ConsumeIntegralInRange(low, high);
  };
  switch (input.ConsumeIntegralInRange(0, 5)) {
    case 0:
      cloud.stride = within(1, packed - 1);
      break;
    case 1:
      cloud.points = nullptr;
      cloud.count = within(1, SIZE_MAX);
      break;
    case 2:
      cloud.normals = cloud.points;
      cloud.normal_stride = within(1, packed - 1);
      break;
    case 3:  // features without numbers, or numbers without features
      cloud.feature_dimension = cloud.features ? 0 : within(1, SIZE_MAX);
      break;
    case 4:
      cloud.features = static_cast<const float*>(cloud.points);
      cloud.feature_dimension = within(65537, SIZE_MAX);
      break;
    default:
      cloud.features = static_cast<const float*>(cloud.points);
      cloud.feature_dimension = within(1, 65536);
      cloud.feature_stride = within(1, 4 * cloud.feature_dimension - 1);
  }
  return cloud;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Input input(data, size);
  const std::string name = input.ConsumeRandomLengthString(8);
  const fuzz::AnyCloud cloud(input, 64, fuzz::any_user_data(input));
  preprocess(cloud.view(), name);

  // The library refuses it before it touches the memory.
  const emtr_cloud wrong = contradiction(cloud.view(), input);
  emtr_preprocessed* preprocessed = nullptr;
  require(!accepted(emtr_preprocess(&wrong, nullptr, 1, &preprocessed)));
  return 0;
}
