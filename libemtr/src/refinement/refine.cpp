#include "refinement/refine.h"

#include "geometry/pose_distance.h"
#include "refinement/information.h"
#include "refinement/local_refinement.h"

namespace emtr {

Refined refine(const FineSurfaces& fine, const Rigid& start, const Settings& settings,
               const Kernels& kernels, const Prior* prior) {
  const LocalRefinement refinement(fine.source, fine.target, fine.near_source.get(),
                                   fine.near_target.get(), LocalRefinementSettings(), kernels);
  LocalRefinement::Scratch scratch;
  const LocalRefinementResult result = refinement(start, prior, scratch, thread_count(settings));

  Refined out;
  out.pose = start;
  // A pose that ran away from what the ranking chose is no refinement of it.
  if (result.end == Termination::TooFewInliers || !is_same_pose(result.pose, start, kDistinctPose))
    return out;
  out.succeeded = true;
  out.pose = result.pose;
  out.rmse = result.rmse;
  out.design_effect = refinement.design_effect(result, scratch, thread_count(settings));
  information(result, out.design_effect, out.information);
  out.hessian_spectrum = hessian_spectrum(result.sums);
  out.unconstrained = prior ? unconstrained_within(out.hessian_spectrum, prior->limits(result.pose))
                            : out.hessian_spectrum.unconstrained;
  return out;
}

}  // namespace emtr
