#pragma once

#include <atomic>
#include <functional>
#include <memory>

#include "candidates/surface_pair.h"
#include "evolution/engine.h"
#include "features/fpfh.h"
#include "correspondences/matching.h"
#include "correspondences/tims.h"
#include "preprocessing/downsampling.h"
#include "correspondences/user_keypoints.h"
#include "priors/prior.h"
#include "pipeline/result.h"
#include "seeds/seeds.h"
#include "tasks/task_alpha.h"
#include "tasks/task_beta.h"
#include "util/cancellation.h"

namespace emtr {

/// With all its points, when the correspondences of the settings will ask for them.
emtr_cloud kept(emtr_cloud cloud, const Settings& given);

/// The walk of the data from two clouds to two tasks, every stage's output kept, and on to a
/// result. Stages run in the order of the members.
class Problem {
 public:
  using Normalize = std::function<NormalizedPair()>;

  /// Throws Error on bad clouds or settings. The watch may stop it; then stopped() holds and only
  /// solve() may be called, whose result says so.
  Problem(const Normalize& normalized, const Settings& settings, CancellationToken& watch);
  /// Of clouds as they are, without a time limit.
  Problem(const emtr_cloud& source, const emtr_cloud& target, const Settings& settings,
          const OnProgress& on_progress);
  /// The same bits, from clouds that were prepared before.
  Problem(const PreprocessedCloudPtr& source, const PreprocessedCloudPtr& target, const Settings& settings,
          const OnProgress& on_progress);

  bool stopped() const { return stopped_; }

  /// Evolution and verdict. Does not change the problem, so it can be repeated.
  std::unique_ptr<Result> solve(CancellationToken& watch) const;
  /// Within the settings' time limit.
  std::unique_ptr<Result> solve(const OnProgress& on_progress) const;

  const Settings settings;
  const Kernels& kernels;  ///< the inner loops in use
  std::size_t dropped_source = 0, dropped_target = 0, points_source = 0, points_target = 0;
  NormalizedPair pair;
  const Normalization& normalization = pair.normalization;
  PriorPtr prior;  ///< null when every pose is admissible
  DownsampledClouds downsampled;
  Features source_features, target_features;  ///< of the dense clouds; no descriptors with `handed`
  std::unique_ptr<FeatureClouds> handed;      ///< null when the dense clouds are matched
  const Cloud& matched_source() const {
    return handed ? handed->source.points : downsampled.source_dense;
  }
  const Cloud& matched_target() const {
    return handed ? handed->target.points : downsampled.target_dense;
  }
  std::vector<Correspondence> correspondences;  ///< rows of matched_source(), matched_target()
  std::size_t correspondences_found = 0;        ///< of which the best are kept
  std::vector<Seed> seeds;
  double tau = 0;
  Tims tims;
  std::unique_ptr<TaskAlpha> alpha;
  std::unique_ptr<TaskBeta> beta;
  std::unique_ptr<KnowledgeComplement> complement;
  std::unique_ptr<SurfacePair> surfaces;     ///< null when the settings ask for no candidates
  std::atomic<std::uint64_t> queries{0};  ///< of calls from outside, stage by stage

 private:
  void make(const Normalize& normalized, const Settings& given, CancellationToken& watch);
  void prepare(const Normalize& normalized, const Settings& given, CancellationToken& watch);
  void load_user_input(const Settings& given);
  void describe_dense();
  void match_features();
  void make_tasks();
  void make_surfaces();
  void find_seeds();

  friend class Registration;
  bool stopped_ = false;
  struct {
    double normalization = 0, downsampled = 0, features = 0, matching = 0, seeds = 0;
  } seconds_;
};

}  // namespace emtr
