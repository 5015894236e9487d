#include "refinement/refine.h"

#include "geometry/pose_distance.h"
#include "refinement/information.h"
#include "refinement/local_refinement.h"

namespace emtr {

Refined refine(const FineSurfaces& fine, const Rigid& start, const Settings& settings,
               const Kernels& kernels, const Prior* prior) {
  const LocalRefinement refine_locally(fine.source, fine.target, fine.near_source.get(),
                             fine.near_target.get(), LocalRefinementSettings(), kernels);
  LocalRefinement::Scratch scratch;
  const LocalRefinementResult p = refine_locally(start, prior, scratch, thread_count(settings));

  Refined out;
  out.pose = start;
  // A pose that ran away from what the ranking chose is no refinement of it.
  if (p.end == Termination::TooFewInliers || !within(p.pose, start, kDistinctPose)) return out;
  out.succeeded = true;
  out.pose = p.pose;
  out.rmse = p.rmse;
  information(p, refine_locally.design_effect(p, scratch), out.information);
  out.hessian_spectrum = hessian_spectrum(p.sums);
  out.unconstrained = prior ? unconstrained_within(out.hessian_spectrum, prior->limits(p.pose)) : out.hessian_spectrum.free;
  return out;
}

}  // namespace emtr
