#pragma once

#include <memory>
#include <optional>

#include "../frame/frame.h"
#include "../seeds/seeds.h"
#include "../settings.h"
#include "pool.h"
#include "surfaces.h"

namespace emtr {

/// Gathers candidates from all who have some, and more of them when those do not convince.
class CandidateSearch {
 public:
  /// All arguments must outlive it. `prior`: what all candidates are to keep to, or null.
  CandidateSearch(const NormalisedPair& pair, const Surfaces& surfaces, const Settings& settings,
                  const Kernels& kernels, const Prior* prior);

  /// The seeds with the best quick score, no copies; see admissible().
  std::vector<Rigid> shortlist(const std::vector<Seed>& seeds) const;

  /// Takes in poses as they are, and the best of `many`.
  void add(const std::vector<Rigid>& poses, const std::vector<Rigid>& many);

  /// Searches again with more feature points, and lets free space have its say.
  void escalate();
  bool escalated() const { return oriented_ != nullptr; }

  const std::vector<Candidate>& ranked() const { return pool_->ranked(); }

 private:
  Viewpoints viewpoints(const Surface& surface, const std::optional<Viewpoint>& given) const;

  const NormalisedPair& pair_;
  const Surfaces& surfaces_;
  const Settings& settings_;
  const Kernels& kernels_;
  const Prior* prior_;
  const int threads_;
  std::unique_ptr<Surfaces> oriented_;  ///< with viewpoints, after an escalation
  std::unique_ptr<Pool> pool_;
};

}  // namespace emtr
