#include "features/pair_features.h"

#include <cmath>
#include <utility>

namespace emtr {
namespace {

struct Vector {
  float x, y, z;
};

/// Adds the terms as PCL's vectors do, which have a fourth number that is 0.
float dot(const Vector& a, const Vector& b) { return (a.x * b.x + a.z * b.z) + (a.y * b.y + 0.0f); }

Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

float norm(const Vector& a) { return std::sqrt(dot(a, a)); }

}  // namespace

PairFeatures pair_features(const float p1[3], const float n1[3], const float p2[3],
                           const float n2[3]) {
  Vector line{p2[0] - p1[0], p2[1] - p1[1], p2[2] - p1[2]};
  Vector u{n1[0], n1[1], n1[2]}, other{n2[0], n2[1], n2[2]};
  const float distance = norm(line);
  if (distance == 0) return {};
  // The frame stands on the point whose normal is closer to the line, whichever comes first.
  const float cosine1 = dot(u, line) / distance, cosine2 = dot(other, line) / distance;
  float f3 = cosine1;
  if (std::acos(std::fabs(cosine1)) > std::acos(std::fabs(cosine2))) {
    std::swap(u, other);
    line = {-line.x, -line.y, -line.z};
    f3 = -cosine2;
  }
  Vector v = cross(line, u);
  const float length = norm(v);
  if (length == 0) return {};
  v = {v.x / length, v.y / length, v.z / length};
  const Vector w = cross(u, v);
  return {std::atan2(dot(w, other), dot(u, other)), dot(v, other), f3, distance};
}

}  // namespace emtr
