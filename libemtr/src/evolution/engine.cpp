#include "evolution/engine.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "evolution/knowledge_transfer.h"
#include "geometry/pose_distance.h"
#include "util/thread_team.h"

namespace emtr {
namespace {

/// Chooses how rotations step; auto steps by vectors where no particle starts at a seed.
RotationSteps rotation_steps(const Settings& settings, const SearchSpace& space, bool seeded) {
  const bool vectors = in_use(settings.rotation_vector_steps, !seeded) && space.has_euler_angles();
  return vectors ? RotationSteps::Vector : RotationSteps::Angles;
}

class Engine {
 public:
  Engine(const TaskAlpha& alpha, const TaskBeta& beta, const KnowledgeComplement& complement,
         const Settings& settings, const Prior* prior, bool seeded, std::size_t threads,
         ThreadTeam& team)
      : team_(team),
        alpha_(alpha),
        beta_(beta),
        settings_(settings),
        space_(settings.translation_bound, prior),
        transfer_(complement, space_, settings, in_use(settings.arc_transfer, !seeded)),
        poses_(space_.pose_genes(), settings, Stream::Alpha,
               rotation_steps(settings, space_, seeded)),
        rotations_(space_.rotation_genes(), settings, Stream::Beta,
                   rotation_steps(settings, space_, seeded)),
        scratch_(threads),
        resolution_(settings.sparse_to_dense ? EMTR_RESOLUTION_SPARSE : EMTR_RESOLUTION_DENSE),
        may_stall_(seeded && may_stall(settings)) {}

  void place(const Starts& starts) {
    std::vector<Rigid> all = starts.guesses;
    all.insert(all.end(), starts.seeds.begin(), starts.seeds.end());
    for (std::size_t i = 0; i < std::min(all.size(), poses_.size()); ++i) {
      double particle[6];
      space_.encode(all[i], particle);
      poses_.place(i, particle);
      rotations_.place(i, particle);
    }
  }

  Evolution run(const OnIteration& on_iteration) {
    const int switch_at =
        static_cast<int>(std::ceil(settings_.switch_fraction * settings_.iterations - 1e-9));
    try {
      for (int it = 0; it < settings_.iterations && !out_.stopped && !stalled(it); ++it) {
        if (resolution_ == EMTR_RESOLUTION_SPARSE && it == switch_at) switch_to_dense();
        evaluate();
        poses_.update_bests();
        beta_changed_ |= rotations_.update_bests();
        out_.history_alpha.push_back(poses_.gbest_fitness());
        out_.history_beta.push_back(rotations_.gbest_fitness());
        move(it);
        out_.stopped = on_iteration(it + 1, poses_.gbest_fitness(), rotations_.gbest_fitness());
      }
    } catch (const Cancelled&) {  // within an iteration: the pbests are those of the one before
      out_.stopped = true;
    }
    if (!out_.history_alpha.empty()) remember();
    out_.resolution = resolution_;
    out_.queries_complement = transfer_.queries();
    return std::move(out_);
  }

 private:
  /// Evaluates the particles of both tasks at once.
  void evaluate() {
    const std::size_t n = poses_.size();
    team_.parallel(n + rotations_.size(), [&](std::size_t i, std::size_t thread) {
      if (i < n) {
        // One that is no better than the particle's best need not be known exactly.
        poses_.fitness()[i] = alpha_.evaluate(resolution_, space_.pose(poses_.position(i)),
                                              poses_.best_fitness(i), scratch_[thread]);
      } else {
        rotations_.fitness()[i - n] = beta_.evaluate(space_.rotation(rotations_.position(i - n)));
      }
    });
    out_.queries_evaluation += n * alpha_.queries(resolution_);
  }

  void remember() {
    out_.best = poses_.gbest();
    for (std::size_t i = 0; i < poses_.size(); ++i) {
      out_.hypotheses.push_back({space_.pose(poses_.best_position(i)), poses_.best_fitness(i)});
    }
  }

  /// Evaluates the pbests anew on the dense clouds (lines 22-26). This iteration evaluates the
  /// positions too, and update_bests() then makes each pbest the better of the two.
  void switch_to_dense() {
    const std::size_t n = poses_.size();
    std::vector<double> fitness(n);
    team_.parallel(n, [&](std::size_t i, std::size_t thread) {
      fitness[i] = alpha_.evaluate(EMTR_RESOLUTION_DENSE, space_.pose(poses_.best_position(i)),
                                   scratch_[thread]);
    });
    resolution_ = EMTR_RESOLUTION_DENSE;
    poses_.set_best_fitness(fitness);
    out_.queries_switch += n * alpha_.queries(resolution_);
  }

  /// Tells whether gbest has stayed for long where local refinement ends in one place: the refined
  /// candidates have it, and the other particles start from seeds that they have too.
  bool stalled(int it) {
    if (!may_stall_ || it == 0) return false;
    const Rigid pose = space_.pose(poses_.best_position(poses_.gbest()));
    if (it == 1 || !is_same_pose(pose, place_, kDuplicatePose)) {
      place_ = pose;
      in_place_since_ = it;
    }
    return it - in_place_since_ >= settings_.stall_iterations;
  }

  void move(int it) {
    const double done = static_cast<double>(it) / settings_.iterations;
    const double inertia =
        settings_.inertia_start + (settings_.inertia_end - settings_.inertia_start) * done;
    auto guides = KnowledgeTransfer::own(poses_, rotations_);
    // Without TIMs task beta's fitness is constant, and its best means nothing.
    if (beta_.informative() && transfer_.due(it)) {
      guides = transfer_.exchange(it, poses_, rotations_, beta_changed_);
      beta_changed_ = false;
    }
    poses_.move(it, inertia, guides.alpha.data());
    rotations_.move(it, inertia, guides.beta.data());
  }

  ThreadTeam& team_;
  const TaskAlpha& alpha_;
  const TaskBeta& beta_;
  const Settings settings_;
  const SearchSpace space_;
  KnowledgeTransfer transfer_;
  Swarm poses_, rotations_;
  std::vector<TaskAlpha::Scratch> scratch_;
  emtr_resolution resolution_;
  bool beta_changed_ = false;  // since the complement was last computed
  bool may_stall_;
  Rigid place_;  // of gbest
  int in_place_since_ = 0;
  Evolution out_;
};

}  // namespace

Evolution evolve(const TaskAlpha& alpha, const TaskBeta& beta,
                 const KnowledgeComplement& complement, const Settings& settings,
                 const Starts& starts, const OnIteration& on_iteration, const Prior* prior) {
  Evolution out;
  const int threads = thread_count(settings);
  ThreadTeam::with(threads, [&](ThreadTeam& team) {
    Engine engine(alpha, beta, complement, settings, prior, !starts.seeds.empty(),
                  static_cast<std::size_t>(threads), team);
    engine.place(starts);
    out = engine.run(on_iteration);
  });
  return out;
}

}  // namespace emtr
