#pragma once

#include <memory>
#include <optional>

#include "preprocessing/normalization.h"
#include "seeds/seeds.h"
#include "settings/settings.h"
#include "candidates/candidate_set.h"
#include "candidates/surface_pair.h"

namespace emtr {

/// Gathers candidates from all who have some, and more of them when those do not convince.
class CandidateSearch {
 public:
  /// All arguments must outlive it. `prior`: what all candidates are to keep to, or null.
  CandidateSearch(const NormalizedPair& pair, const SurfacePair& surfaces, const Settings& settings,
                  const Kernels& kernels, const Prior* prior);

  /// The seeds with the best quick score, no copies; see admissible().
  std::vector<Rigid> shortlist(const std::vector<Seed>& seeds) const;

  /// Takes in poses as they are, and the best of `many`.
  void add(const std::vector<Rigid>& poses, const std::vector<Rigid>& many);

  /// Searches again with more feature points, and lets free space have its say.
  void run_fallback_search();
  bool used_fallback_search() const { return oriented_ != nullptr; }

  const std::vector<Candidate>& ranked() const { return candidate_set_->ranked(); }

 private:
  Viewpoints viewpoints(const Surface& surface, const std::optional<Viewpoint>& given) const;

  const NormalizedPair& pair_;
  const SurfacePair& surfaces_;
  const Settings& settings_;
  const Kernels& kernels_;
  const Prior* prior_;
  const int threads_;
  std::unique_ptr<SurfacePair> oriented_;  ///< with viewpoints, after an fallback search
  std::unique_ptr<CandidateSet> candidate_set_;
};

}  // namespace emtr
