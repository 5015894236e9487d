#include "refine.h"

#include <algorithm>

#include "../candidates/modes.h"
#include "information.h"
#include "local_polish.h"
#include "surface.h"

namespace emtr {

namespace {

constexpr double kLeastSpacings = 2;  // a leaf; finer ones hold single points, without normals
constexpr double kQueries = 5e4;      // look-ups of one polish, about

}  // namespace

Refined refine(const NormalisedPair& pair, const Rigid& start, const Settings& settings,
               const Kernels& kernels) {
  // Finer than its points are spaced a surface has no normals.
  const double spacing = std::max(pair.prepared_source->spacing() * pair.prepared_source->radius,
                                  pair.prepared_target->spacing() * pair.prepared_target->radius) /
                         pair.frame.scale;
  const double leaf = std::max(settings.refine_leaf, kLeastSpacings * spacing);
  const Surface source = thin_surface(pair.source, leaf), target = thin_surface(pair.target, leaf);
  const Polish polish;
  const auto reach = static_cast<float>(std::max(polish.first_scale, polish.reach) * leaf);
  const auto near = [&](const Surface& surface) {
    return make_neighbors(surface.points, reach, static_cast<float>(1.5 * leaf), kQueries, kernels);
  };
  const auto near_source = near(source), near_target = near(target);
  const LocalPolish polished(source, target, near_source.get(), near_target.get(), polish, kernels);
  LocalPolish::Scratch scratch;
  const Polished p = polished(start, scratch, thread_count(settings));

  Refined out;
  out.pose = start;
  // A pose that ran away from what the ranking chose is no refinement of it.
  if (p.end == PolishEnd::TooFewInliers || !within(p.pose, start, kMode)) return out;
  out.succeeded = true;
  out.pose = p.pose;
  out.rmse = p.rmse;
  information(p, out.information);
  out.spectrum = spectrum(p.sums);
  return out;
}

}  // namespace emtr
