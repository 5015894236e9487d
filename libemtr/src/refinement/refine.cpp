#include "refine.h"

#include <algorithm>
#include <cmath>

#include "../candidates/modes.h"
#include "information.h"
#include "local_polish.h"
#include "surface.h"

namespace emtr {

namespace {

constexpr double kLeastPoints = 3;  // a cube, on average; finer ones have no normals worth the name
constexpr int kMostAttempts = 4;
constexpr double kQueries = 5e4;  // look-ups of one polish, about

struct FineSurfaces {
  Surface source, target;
};

/// At the leaf asked for, or as fine as the sparser cloud allows.
FineSurfaces fine_surfaces(const NormalisedPair& pair, double leaf) {
  FineSurfaces out;
  for (int attempt = 0;; ++attempt) {
    out = {thin_surface(pair.source, leaf), thin_surface(pair.target, leaf)};
    const auto filling = [](const Cloud& points, const Surface& surface) {
      return static_cast<double>(points.size()) / static_cast<double>(surface.points.size());
    };
    const double least =
        std::min(filling(pair.source, out.source), filling(pair.target, out.target));
    if (least >= kLeastPoints || attempt == kMostAttempts) return out;
    leaf *= std::sqrt(1.1 * kLeastPoints / least);
  }
}

}  // namespace

Refined refine(const NormalisedPair& pair, const Rigid& start, const Settings& settings,
               const Kernels& kernels, const Prior* prior) {
  const FineSurfaces fine = fine_surfaces(pair, settings.refine_leaf);
  const Surface &source = fine.source, &target = fine.target;
  const double leaf = source.leaf;
  const Polish polish;
  const auto reach = static_cast<float>(std::max(polish.first_scale, polish.reach) * leaf);
  const auto near = [&](const Surface& surface) {
    return make_neighbors(surface.points, reach, static_cast<float>(1.5 * leaf), kQueries, kernels);
  };
  const auto near_source = near(source), near_target = near(target);
  const LocalPolish polished(source, target, near_source.get(), near_target.get(), polish, kernels);
  LocalPolish::Scratch scratch;
  const Polished p = polished(start, scratch, thread_count(settings), prior);

  Refined out;
  out.pose = start;
  // A pose that ran away from what the ranking chose is no refinement of it.
  if (p.end == PolishEnd::TooFewInliers || !within(p.pose, start, kMode)) return out;
  out.succeeded = true;
  out.pose = p.pose;
  out.rmse = p.rmse;
  information(p, out.information);
  out.spectrum = spectrum(p.sums);
  out.slides = prior ? free_within(out.spectrum, prior->limits(p.pose)) : out.spectrum.free;
  return out;
}

}  // namespace emtr
