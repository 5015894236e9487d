#pragma once

#include <atomic>
#include <functional>
#include <memory>

#include "candidates/surfaces.h"
#include "evolution/engine.h"
#include "features/fpfh.h"
#include "features/matching.h"
#include "features/tims.h"
#include "frame/densities.h"
#include "frame/handed_features.h"
#include "priors/prior.h"
#include "result.h"
#include "seeds/seeds.h"
#include "tasks/task_alpha.h"
#include "tasks/task_beta.h"
#include "watch.h"

namespace emtr {

/// With all its points, when the correspondences of the settings will ask for them.
emtr_cloud kept(emtr_cloud cloud, const Settings& given);

/// The walk of the data from two clouds to two tasks, every stage's output kept, and on to a
/// result. Stages run in the order of the members.
class Problem {
 public:
  using Normalise = std::function<NormalisedPair()>;

  /// Throws Error on bad clouds or settings. The watch may stop it; then stopped() holds and only
  /// solve() may be called, whose result says so.
  Problem(const Normalise& normalised, const Settings& settings, Watch& watch);
  /// Of clouds as they are, without a time limit.
  Problem(const emtr_cloud& source, const emtr_cloud& target, const Settings& settings,
          const OnProgress& on_progress);
  /// The same bits, from clouds that were prepared before.
  Problem(const PreparedCloudPtr& source, const PreparedCloudPtr& target, const Settings& settings,
          const OnProgress& on_progress);

  bool stopped() const { return stopped_; }

  /// Evolution and verdict. Does not change the problem, so it can be repeated.
  std::unique_ptr<Result> solve(Watch& watch) const;
  /// Within the settings' time limit.
  std::unique_ptr<Result> solve(const OnProgress& on_progress) const;

  const Settings settings;
  const Kernels& kernels;  ///< the inner loops in use
  std::size_t dropped_source = 0, dropped_target = 0, points_source = 0, points_target = 0;
  NormalisedPair pair;
  const Frame& frame = pair.frame;
  PriorPtr prior;  ///< null when every pose is admissible
  Densities densities;
  Features source_features, target_features;  ///< of the dense clouds; no descriptors with `handed`
  std::unique_ptr<FeatureClouds> handed;      ///< null when the dense clouds are matched
  const Cloud& matched_source() const {
    return handed ? handed->source.points : densities.source_dense;
  }
  const Cloud& matched_target() const {
    return handed ? handed->target.points : densities.target_dense;
  }
  std::vector<Correspondence> correspondences;  ///< rows of matched_source(), matched_target()
  std::size_t correspondences_found = 0;        ///< of which the best are kept
  std::vector<Seed> seeds;
  double tau = 0;
  Tims tims;
  std::unique_ptr<TaskAlpha> alpha;
  std::unique_ptr<TaskBeta> beta;
  std::unique_ptr<KnowledgeComplement> complement;
  std::unique_ptr<Surfaces> surfaces;     ///< null when the settings ask for no candidates
  std::atomic<std::uint64_t> lookups{0};  ///< of calls from outside, stage by stage

 private:
  void make(const Normalise& normalised, const Settings& given, Watch& watch);
  void prepare(const Normalise& normalised, const Settings& given, Watch& watch);
  void take_handed(const Settings& given);
  void describe_dense();
  void match_features();
  void make_tasks();
  void make_surfaces();
  void find_seeds();

  friend class Registration;
  bool stopped_ = false;
  struct {
    double frame = 0, densities = 0, features = 0, matching = 0, seeds = 0;
  } seconds_;
};

}  // namespace emtr
