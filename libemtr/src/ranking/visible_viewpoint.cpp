#include "ranking/visible_viewpoint.h"

#include <algorithm>
#include <cmath>

#include "ranking/directions.h"
#include "ranking/z_buffer.h"
#include "util/cancellation.h"

namespace emtr {
namespace {

constexpr std::size_t kDirections = 100;
constexpr double kRadii[] = {1.26, 2.34, 4.33, 8};
constexpr double kNarrow = 1, kWide = 2;  // leaves: bins to find a direction, and to judge it by
constexpr std::size_t kPromising = 30;    // directions that are looked at with all points
/// Places that see nearly as much as the best, by this share, have a say in the estimate: a sensor
/// stands in the middle of them rather than at the very best.
constexpr double kNearlyBest = 0.03;

struct View {
  Direction direction;
  double radius, share;
};

double dot(const Direction& a, const Direction& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Viewpoint place(const Direction& centroid, const Direction& direction, double radius) {
  Viewpoint out;
  out.trust = 0;
  out.given = false;
  for (std::size_t a = 0; a < 3; ++a) out.at[a] = centroid[a] + radius * direction[a];
  return out;
}

/// Finds the radius that sees most along a direction.
View best_along(ZBuffer& buffer, const Direction& direction) {
  View best{direction, 0, -1};
  for (const double radius : kRadii) {
    check_cancelled();
    const double share = buffer.visible_share(place(buffer.centroid(), direction, radius).at);
    if (share > best.share) best = {direction, radius, share};
  }
  return best;
}

/// Finds the directions that may matter by a quarter of the points, which lie twice as far apart.
std::vector<View> promising(const Surface& surface, const Kernels& kernels) {
  Surface some = every_nth(surface, 4);
  some.leaf = 2 * surface.leaf;
  ZBuffer buffer(some, kNarrow, kernels);
  std::vector<View> views;
  for (const Direction& direction : spread_directions(kDirections))
    views.push_back(best_along(buffer, direction));
  std::stable_sort(views.begin(), views.end(),
                   [](const View& a, const View& b) { return a.share > b.share; });
  views.resize(kPromising);
  return views;
}

/// Returns the mean direction of those that see nearly as much as the best. Opposites count for one
/// another: which side is the sensor's is open anyway.
Direction middle(const std::vector<View>& views, const View& best) {
  Direction sum{};
  for (const View& view : views) {
    const double near = 1 - (best.share - view.share) / kNearlyBest;
    const double cosine = dot(view.direction, best.direction);
    if (near <= 0 || std::abs(cosine) < 0.5) continue;
    for (std::size_t a = 0; a < 3; ++a)
      sum[a] += near * near * (cosine < 0 ? -view.direction[a] : view.direction[a]);
  }
  const double length = std::sqrt(dot(sum, sum));
  return {sum[0] / length, sum[1] / length, sum[2] / length};
}

}  // namespace

std::optional<Viewpoint> estimate_visible_viewpoint(const Surface& surface,
                                                    const Kernels& kernels) {
  ZBuffer narrow(surface, kNarrow, kernels), wide(surface, kWide, kernels);
  const Direction& centroid = narrow.centroid();
  std::vector<View> views = promising(surface, kernels);
  double visible = 0;
  for (View& view : views) {
    check_cancelled();
    const Viewpoint at = place(centroid, view.direction, view.radius);
    view.share = narrow.visible_share(at.at);
    visible = std::max(visible, wide.visible_share(at.at));
  }
  if (visible < kMinimumVisible) return std::nullopt;
  const View best = *std::max_element(
      views.begin(), views.end(), [](const View& a, const View& b) { return a.share < b.share; });
  const View found = best_along(narrow, middle(views, best));
  return place(centroid, found.direction, found.radius);
}

}  // namespace emtr
