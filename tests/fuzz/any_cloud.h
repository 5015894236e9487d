#pragma once

#include <emtr/emtr.h>

#include "any_rows.h"
#include "any_surface.h"

namespace fuzz {

/// What clouds are handed in with.
struct Handed {
  bool normals = false;
  std::size_t dimension = 0;  ///< of the features, 0: none
};

inline Handed any_user_input(Input& input) {
  Handed out;
  out.normals = input.ConsumeIntegralInRange(0, 2) == 2;
  if (input.ConsumeIntegralInRange(0, 2) == 2)
    out.dimension = input.ConsumeBool() ? 3 : input.ConsumeIntegralInRange<std::size_t>(1, 40);
  return out;
}

/// A cloud for the C API: points, and what they may be handed in with.
class AnyCloud {
 public:
  /// Of at most `most` points; handed in as said, or now and then otherwise than its partner.
  AnyCloud(Input& input, std::size_t most, Handed handed = {}) {
    if (input.ConsumeIntegralInRange(0, 15) == 15) handed = any_user_input(input);
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
    if (handed.normals) set_user_normals(surface, input);
    if (handed.dimension) set_user_features(surface, handed.dimension, input);
    view_.keep_points = input.ConsumeBool();
  }

  const emtr_cloud& view() const { return view_; }
  double coordinate(std::size_t i, std::size_t axis) const { return points_.get(i, axis); }

 private:
  void set_user_normals(const AnySurface& surface, Input& input) {
    normals_ = AnyRows(input, view_.count, 3, view_.scalar);
    for (std::size_t i = 0; i < view_.count; ++i) {
      const AnySurface::Vector n = surface.normal(i);
      for (std::size_t k = 0; k < 3; ++k) normals_.set(i, k, n[k]);
    }
    spoil(normals_, view_.count, 3, 2, input);
    view_.normals = normals_.data();
    view_.normal_stride = normals_.stride();
  }

  void set_user_features(const AnySurface& surface, std::size_t dimension, Input& input) {
    features_ = AnyRows(input, view_.count, dimension, EMTR_FLOAT32);
    for (std::size_t i = 0; i < view_.count; ++i)
      for (std::size_t d = 0; d < dimension; ++d) features_.set(i, d, surface.descriptor(i, d));
    spoil(features_, view_.count, dimension, 2, input);
    view_.features = static_cast<const float*>(features_.data());
    view_.feature_dimension = dimension;
    view_.feature_stride = features_.stride();
  }

  /// Some numbers, `most` at most, become any number; seldom all become any bytes.
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
