#include "evolution/knowledge_transfer.h"

#include <algorithm>

namespace emtr {
namespace {

/// lambda, linear over the iterations.
double share(double start, double end, int iteration, int iterations) {
  return start + (end - start) * iteration / iterations;
}

}  // namespace

KnowledgeTransfer::Guides KnowledgeTransfer::own(const Swarm& alpha, const Swarm& beta) {
  Guides guides;
  std::copy_n(alpha.gbest_position(), alpha.dimensions(), guides.alpha.begin());
  std::copy_n(beta.gbest_position(), beta.dimensions(), guides.beta.begin());
  return guides;
}

bool KnowledgeTransfer::due(int iteration) const {
  const auto word =
      draw(settings_.seed, static_cast<std::uint64_t>(iteration), Stream::Transfer, 0, 0);
  return settings_.transfer && uniform(word[0]) < settings_.transfer_probability;
}

KnowledgeTransfer::Guides KnowledgeTransfer::exchange(int iteration, const Swarm& alpha,
                                                      const Swarm& beta, bool beta_changed) {
  const double* a = alpha.gbest_position();
  const double* b = beta.gbest_position();
  if (settings_.complement && (beta_changed || !known_)) {
    Rigid pose;
    pose.R = space_.rotation(b);
    pose.t = complement_.translation(pose.R, space_.prior());
    space_.encode_translation(pose, translation_.data());
    queries_ += complement_.queries();
    known_ = true;
  }

  const double la = share(settings_.lambda_alpha_start, settings_.lambda_alpha_end, iteration,
                          settings_.iterations);
  const double lb = share(settings_.lambda_beta_start, settings_.lambda_beta_end, iteration,
                          settings_.iterations);
  Guides guides;
  mix(a, b, la, guides.alpha.data());
  mix(b, a, lb, guides.beta.data());
  const std::size_t angles = space_.angles();
  // Without the complement alpha keeps its own translation.
  for (std::size_t k = 0; k < 3; ++k) {
    const double own = a[angles + k];
    guides.alpha[angles + k] = settings_.complement ? la * own + (1 - la) * translation_[k] : own;
  }
  return guides;
}

void KnowledgeTransfer::mix(const double* own, const double* other, double share,
                            double* out) const {
  if (arc_) return space_.arc(own, other, 1 - share, out);
  double seen[3];
  space_.nearest_alias(other, own, seen);
  for (std::size_t k = 0; k < space_.angles(); ++k) out[k] = share * own[k] + (1 - share) * seen[k];
}

}  // namespace emtr
