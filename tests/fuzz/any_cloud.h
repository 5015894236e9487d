#pragma once

#include <emtr/emtr.h>

#include "any_rows.h"
#include "any_surface.h"

namespace fuzz {

/// The data that the user provides with a cloud, beside its points.
struct UserData {
  bool normals = false;
  std::size_t dimension = 0;  ///< numbers of each feature, 0: no features
};

inline UserData any_user_data(Input& input) {
  UserData out;
  out.normals = input.ConsumeIntegralInRange(0, 2) == 2;
  if (input.ConsumeIntegralInRange(0, 2) == 2)
    out.dimension = input.ConsumeBool() ? 3 : input.ConsumeIntegralInRange<std::size_t>(1, 40);
  return out;
}

/// A cloud for the C API: points, and perhaps normals and features.
class AnyCloud {
 public:
  /// Makes at most `most` points with this data, or now and then with other data, so that the two
  /// clouds of a pair differ.
  AnyCloud(Input& input, std::size_t most, UserData user = {}) {
    if (input.ConsumeIntegralInRange(0, 15) == 15) user = any_user_data(input);
    const AnySurface surface(input);
    const std::size_t count = most - input.ConsumeIntegralInRange<std::size_t>(0, most);
    view_.count = count;
    view_.scalar = input.ConsumeBool() ? EMTR_FLOAT32 : EMTR_FLOAT64;

    points_ = AnyRows(input, count, 3, view_.scalar);
    for (std::size_t i = 0; i < count; ++i) {
      const AnySurface::Vector p = surface.point(i, input);
      for (std::size_t k = 0; k < 3; ++k) points_.set(i, k, p[k]);
    }
    spoil(points_, count, 3, 4, input);
    view_.points = points_.data();
    view_.stride = points_.stride();
    if (user.normals) add_normals(surface, input);
    if (user.dimension) add_features(surface, user.dimension, input);
    view_.keep_points = input.ConsumeBool();
  }

  const emtr_cloud& view() const { return view_; }
  double coordinate(std::size_t i, std::size_t axis) const { return points_.get(i, axis); }

 private:
  void add_normals(const AnySurface& surface, Input& input) {
    normals_ = AnyRows(input, view_.count, 3, view_.scalar);
    for (std::size_t i = 0; i < view_.count; ++i) {
      const AnySurface::Vector n = surface.normal(i);
      for (std::size_t k = 0; k < 3; ++k) normals_.set(i, k, n[k]);
    }
    spoil(normals_, view_.count, 3, 2, input);
    view_.normals = normals_.data();
    view_.normal_stride = normals_.stride();
  }

  void add_features(const AnySurface& surface, std::size_t dimension, Input& input) {
    features_ = AnyRows(input, view_.count, dimension, EMTR_FLOAT32);
    for (std::size_t i = 0; i < view_.count; ++i)
      for (std::size_t d = 0; d < dimension; ++d) features_.set(i, d, surface.descriptor(i, d));
    spoil(features_, view_.count, dimension, 2, input);
    view_.features = static_cast<const float*>(features_.data());
    view_.feature_dimension = dimension;
    view_.feature_stride = features_.stride();
  }

  /// Replaces at most `most` numbers by any number, or seldom the whole memory by any bytes.
  static void spoil(AnyRows& rows, std::size_t count, std::size_t columns, int most, Input& input) {
    if (count == 0) return;
    if (input.ConsumeIntegralInRange(0, 15) == 15) rows.overwrite(input);
    for (int n = input.ConsumeIntegralInRange(0, most); n > 0; --n)
      rows.set(input.ConsumeIntegralInRange<std::size_t>(0, count - 1),
               input.ConsumeIntegralInRange<std::size_t>(0, columns - 1), any_double(input));
  }

  AnyRows points_, normals_, features_;
  emtr_cloud view_{};
};

}  // namespace fuzz
