#pragma once

#include <optional>

#include "geometry/surface.h"
#include "ranking/viewpoint.h"

namespace emtr {

/// The share of the points that must be visible for an estimate. In closed models 0.6 to 0.74 is,
/// in scans, several scans fused into one included, more than 0.8.
constexpr double kMinimumVisible = 0.8;

/// Estimates the place that sees most of the cloud, for normals to be oriented to; none when even
/// that one sees too little. Returns the middle of those places that see most, among 400 around the
/// cloud: 100 directions from its centroid, at radii of 1.26 to 8, the normalized frame's being 1.
/// Not nearer: from inside, a closed model is as visible as a room. The signs of the normals do not
/// matter. A thin sheet looks the same from behind, so the place may as well be the one mirrored in
/// the centroid: it has no trust.
std::optional<Viewpoint> estimate_visible_viewpoint(const Surface& surface, const Kernels& kernels);

}  // namespace emtr
