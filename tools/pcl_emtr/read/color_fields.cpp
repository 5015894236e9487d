#include "read/color_fields.h"

#include <pcl/common/io.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace cli {
namespace {

using Field = pcl::PCLPointField;

const Field* find(const CloudFile& cloud, const char* name) {
  const int index = pcl::getFieldIndex(cloud.blob, name);
  if (index < 0) return nullptr;
  const Field& field = cloud.blob.fields[static_cast<std::size_t>(index)];
  return field.count <= 1 ? &field : nullptr;
}

template <class T>
float as_float(const std::uint8_t* at) {
  T value;
  std::memcpy(&value, at, sizeof value);
  return static_cast<float>(value);
}

float read(const Field& field, const std::uint8_t* point) {
  const std::uint8_t* at = point + field.offset;
  switch (field.datatype) {
    case Field::INT8:
      return as_float<std::int8_t>(at);
    case Field::UINT8:
      return as_float<std::uint8_t>(at);
    case Field::INT16:
      return as_float<std::int16_t>(at);
    case Field::UINT16:
      return as_float<std::uint16_t>(at);
    case Field::INT32:
      return as_float<std::int32_t>(at);
    case Field::UINT32:
      return as_float<std::uint32_t>(at);
    case Field::FLOAT64:
      return as_float<double>(at);
    default:
      return as_float<float>(at);
  }
}

bool is_real(const Field& field) {
  return field.datatype == Field::FLOAT32 || field.datatype == Field::FLOAT64;
}

const std::uint8_t* point(const CloudFile& cloud, std::size_t i) {
  return cloud.blob.data.data() + i * cloud.blob.point_step;
}

/// Divides the colors by the largest number that their type is used to.
void scale(std::vector<float>& colors, bool real) {
  float most = 0;
  for (const float v : colors)
    if (std::isfinite(v)) most = std::max(most, v);
  const float full = real && most <= 1 ? 1.0f : most <= 255 ? 255.0f : 65535.0f;
  for (float& v : colors) v /= full;
}

/// Four bytes: blue, green, red, and alpha or nothing.
bool read_packed(const CloudFile& cloud, std::vector<float>& colors) {
  const Field* field = find(cloud, "rgb");
  if (!field) field = find(cloud, "rgba");
  if (!field || (field->datatype != Field::FLOAT32 && field->datatype != Field::UINT32 &&
                 field->datatype != Field::INT32))
    return false;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    std::uint32_t bits;
    std::memcpy(&bits, point(cloud, i) + field->offset, sizeof bits);
    for (const int place : {16, 8, 0})
      colors.push_back(static_cast<float>((bits >> place) & 255u) / 255.0f);
  }
  return true;
}

bool read_separate(const CloudFile& cloud, std::vector<float>& colors) {
  for (const auto& names : {std::array<const char*, 3>{"red", "green", "blue"}, {"r", "g", "b"}}) {
    const std::array<const Field*, 3> fields = {find(cloud, names[0]), find(cloud, names[1]),
                                                find(cloud, names[2])};
    if (!fields[0] || !fields[1] || !fields[2]) continue;
    for (std::size_t i = 0; i < cloud.size(); ++i)
      for (const Field* field : fields) colors.push_back(read(*field, point(cloud, i)));
    scale(colors, is_real(*fields[0]));
    return true;
  }
  return false;
}

}  // namespace

void attach_colors(const CloudFile& cloud, emtr_cloud& view, ColorFields& copy) {
  const auto lit = [](float v) { return v > 0; };  // LAS has black where nobody set the colors
  if ((read_packed(cloud, copy.colors) || read_separate(cloud, copy.colors)) &&
      std::any_of(copy.colors.begin(), copy.colors.end(), lit))
    view.colors = copy.colors.data();
  const Field* intensity = find(cloud, "intensity");
  if (!intensity) return;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    copy.intensities.push_back(read(*intensity, point(cloud, i)));
  view.intensities = copy.intensities.data();
}

}  // namespace cli
