#include "refine.h"

#include "../candidates/modes.h"
#include "information.h"
#include "local_polish.h"

namespace emtr {

Refined refine(const FineSurfaces& fine, const Rigid& start, const Settings& settings,
               const Kernels& kernels, const Prior* prior) {
  const LocalPolish polished(fine.source, fine.target, fine.near_source.get(),
                             fine.near_target.get(), Polish(), kernels);
  LocalPolish::Scratch scratch;
  const Polished p = polished(start, prior, scratch, thread_count(settings));

  Refined out;
  out.pose = start;
  // A pose that ran away from what the ranking chose is no refinement of it.
  if (p.end == PolishEnd::TooFewInliers || !within(p.pose, start, kMode)) return out;
  out.succeeded = true;
  out.pose = p.pose;
  out.rmse = p.rmse;
  information(p, polished.design_effect(p, scratch), out.information);
  out.spectrum = spectrum(p.sums);
  out.slides = prior ? free_within(out.spectrum, prior->limits(p.pose)) : out.spectrum.free;
  return out;
}

}  // namespace emtr
