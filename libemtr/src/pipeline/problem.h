#pragma once

#include <memory>
#include <vector>

#include "candidates/surface_pair.h"
#include "correspondences/matching.h"
#include "correspondences/tims.h"
#include "correspondences/user_correspondences.h"
#include "correspondences/user_keypoints.h"
#include "evolution/knowledge_complement.h"
#include "features/fpfh.h"
#include "kernels/kernels.h"
#include "pipeline/input_cloud.h"
#include "pipeline/stage_seconds.h"
#include "preprocessing/downsampling.h"
#include "priors/prior.h"
#include "seeds/match_pose.h"
#include "seeds/seeds.h"
#include "tasks/task_alpha.h"
#include "tasks/task_beta.h"
#include "util/cancellation.h"

namespace emtr {

/// A pair of clouds on which poses can be searched. Holds the results of the stages before the
/// search, in their order. Members refer to each other, so a problem stays where it was made.
struct Problem {
  Problem() = default;
  Problem(const Problem&) = delete;
  Problem& operator=(const Problem&) = delete;

  Settings settings{};                        ///< without the user's correspondences
  const Kernels& kernels = select_kernels();  ///< the inner loops in use

  NormalizedPair pair;
  PriorPtr prior;  ///< null when every pose is admissible

  UserCorrespondences user_matches;    ///< empty when the user provides none
  std::vector<MatchPose> match_poses;  ///< that they agree on, the best first
  bool matches_decide = false;         ///< they give the pose and the verdict, not the surfaces

  DownsampledClouds downsampled;

  std::shared_ptr<const Features> source_features, target_features;  ///< of the dense clouds
  std::vector<double> features_by[2];            ///< what they and the leaf were made by
  std::unique_ptr<KeypointPair> user_keypoints;  ///< null when the dense clouds are matched

  std::vector<Correspondence> correspondences;  ///< rows of matched_source(), matched_target()
  std::size_t correspondences_found = 0;        ///< before the best of them were kept
  double tau = 0;
  Tims tims;
  std::unique_ptr<TaskAlpha> alpha;
  std::unique_ptr<TaskBeta> beta;
  std::unique_ptr<KnowledgeComplement> complement;
  std::unique_ptr<SurfacePair> surfaces;  ///< null when the settings ask for no candidates

  std::vector<Seed> seeds;

  StageSeconds seconds;
  bool stopped = false;  ///< the run ended in one of these stages, and the later ones are empty

  const Cloud& matched_source() const {
    return user_keypoints ? user_keypoints->source.points : downsampled.source_dense;
  }
  const Cloud& matched_target() const {
    return user_keypoints ? user_keypoints->target.points : downsampled.target_dense;
  }
};

/// Which stages of a problem are made: all, those that a solution needs, which are not the tasks
/// where the matches decide; or those up to the matches.
enum class Stages { All, Needed, Matches };

/// Makes a problem of two clouds. Keeps nothing of the user's memory. Throws Error on bad clouds or
/// settings. The token may stop it; then the problem is `stopped`, and solve() says so. `seconds`:
/// what the run has taken before.
std::unique_ptr<const Problem> make_problem(InputCloud& source, InputCloud& target,
                                            const Settings& settings, CancellationToken& token,
                                            Stages stages = Stages::All,
                                            const StageSeconds& seconds = {});

}  // namespace emtr
