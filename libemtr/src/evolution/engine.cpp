#include "engine.h"

#include <algorithm>
#include <cmath>

#include "../team.h"
#include "knowledge_transfer.h"

namespace emtr {
namespace {

class Engine {
 public:
  Engine(const TaskAlpha& alpha, const TaskBeta& beta, const KnowledgeComplement& complement,
         const Settings& settings, const Prior* prior, std::size_t threads, Team& team)
      : team_(team),
        alpha_(alpha),
        beta_(beta),
        settings_(settings),
        space_(settings.translation_bound, prior),
        transfer_(complement, space_, settings),
        poses_(space_.pose_genes(), settings, Stream::Alpha),
        rotations_(space_.rotation_genes(), settings, Stream::Beta),
        scratch_(threads),
        stage_(settings.sparse_to_dense ? EMTR_STAGE_SPARSE : EMTR_STAGE_DENSE) {}

  void place(const std::vector<Rigid>& starts) {
    for (std::size_t i = 0; i < std::min(starts.size(), poses_.size()); ++i) {
      double particle[6];
      space_.encode(starts[i], particle);
      poses_.place(i, particle);
      rotations_.place(i, particle);
    }
  }

  Evolution run(const OnIteration& on_iteration) {
    const int switch_at =
        static_cast<int>(std::ceil(settings_.switch_fraction * settings_.iterations - 1e-9));
    try {
      for (int it = 0; it < settings_.iterations && !out_.stopped; ++it) {
        if (stage_ == EMTR_STAGE_SPARSE && it == switch_at) become_dense();
        evaluate();
        poses_.update_bests();
        beta_changed_ |= rotations_.update_bests();
        out_.history_alpha.push_back(poses_.gbest_fitness());
        out_.history_beta.push_back(rotations_.gbest_fitness());
        move(it);
        out_.stopped = on_iteration(it + 1, poses_.gbest_fitness(), rotations_.gbest_fitness());
      }
    } catch (const Stopped&) {  // in the midst of an iteration: the pbests are those before it
      out_.stopped = true;
    }
    const std::size_t remembered = out_.history_alpha.empty() ? 0 : poses_.size();
    for (std::size_t i = 0; i < remembered; ++i)
      out_.hypotheses.push_back({space_.pose(poses_.best_position(i)), poses_.best_fitness(i)});
    out_.best = poses_.gbest();
    out_.stage = stage_;
    out_.lookups_complement = transfer_.lookups();
    return std::move(out_);
  }

 private:
  /// The particles of both tasks at once.
  void evaluate() {
    const std::size_t n = poses_.size();
    team_.parallel(n + rotations_.size(), [&](std::size_t i, std::size_t thread) {
      if (i < n) {
        poses_.fitness()[i] =
            alpha_.evaluate(stage_, space_.pose(poses_.position(i)), scratch_[thread]);
      } else {
        double R[9];
        space_.rotation(rotations_.position(i - n), R);
        rotations_.fitness()[i - n] = beta_.evaluate(R);
      }
    });
    out_.lookups_evaluation += n * alpha_.lookups(stage_);
  }

  /// Lines 22-26: the pbests are scored anew; the positions are in this iteration's evaluation
  /// anyway, and update_bests() then makes each pbest the better of the two.
  void become_dense() {
    std::vector<double> fitness(poses_.size());
    team_.parallel(poses_.size(), [&](std::size_t i, std::size_t thread) {
      fitness[i] =
          alpha_.evaluate(EMTR_STAGE_DENSE, space_.pose(poses_.best_position(i)), scratch_[thread]);
    });
    stage_ = EMTR_STAGE_DENSE;
    poses_.set_best_fitness(fitness);
    out_.lookups_switch += poses_.size() * alpha_.lookups(stage_);
  }

  void move(int it) {
    const double done = static_cast<double>(it) / settings_.iterations;
    const double inertia =
        settings_.inertia_start + (settings_.inertia_end - settings_.inertia_start) * done;
    auto guides = KnowledgeTransfer::own(poses_, rotations_);
    // Without TIMs task beta's fitness is flat, and its best is as good as any.
    if (beta_.informative() && transfer_.due(it)) {
      guides = transfer_.exchange(it, poses_, rotations_, beta_changed_);
      beta_changed_ = false;
    }
    poses_.move(it, inertia, guides.alpha.data());
    rotations_.move(it, inertia, guides.beta.data());
  }

  Team& team_;
  const TaskAlpha& alpha_;
  const TaskBeta& beta_;
  const Settings settings_;
  const SearchSpace space_;
  KnowledgeTransfer transfer_;
  Swarm poses_, rotations_;
  std::vector<TaskAlpha::Scratch> scratch_;
  emtr_stage stage_;
  bool beta_changed_ = false;  // since the complement was last worked out
  Evolution out_;
};

}  // namespace

Evolution evolve(const TaskAlpha& alpha, const TaskBeta& beta,
                 const KnowledgeComplement& complement, const Settings& settings,
                 const std::vector<Rigid>& starts, const OnIteration& on_iteration,
                 const Prior* prior) {
  Evolution out;
  const int threads = thread_count(settings);
  Team::with(threads, [&](Team& team) {
    Engine engine(alpha, beta, complement, settings, prior, static_cast<std::size_t>(threads),
                  team);
    engine.place(starts);
    out = engine.run(on_iteration);
  });
  return out;
}

}  // namespace emtr
