#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "candidates/candidate_set.h"
#include "candidates/surface_pair.h"
#include "preprocessing/normalization.h"
#include "seeds/seeds.h"
#include "settings/settings.h"

namespace emtr {

/// Gathers candidates from all who have some, and searches for more when those do not convince.
class CandidateSearch {
 public:
  /// All arguments must outlive it. `prior`: admits all candidates, or null.
  CandidateSearch(const NormalizedPair& pair, const SurfacePair& surfaces, const Settings& settings,
                  const Kernels& kernels, const Prior* prior);

  /// Returns the seeds with the best quick scores, without duplicates; see admissible().
  std::vector<Rigid> shortlist(const std::vector<Seed>& seeds) const;

  /// Adds poses as they are, and the best of `many`.
  void add(const std::vector<Rigid>& poses, const std::vector<Rigid>& many);

  /// Searches again with more keypoints, and ranks by free space too.
  void run_fallback_search();
  bool used_fallback_search() const { return oriented_ != nullptr; }

  const std::vector<Candidate>& ranked() const { return candidates_->ranked(); }

 private:
  Viewpoints viewpoints(const Surface& surface, const std::optional<Viewpoint>& given) const;

  const NormalizedPair& pair_;
  const SurfacePair& surfaces_;
  const Settings& settings_;
  const Kernels& kernels_;
  const Prior* prior_;
  const int threads_;
  std::unique_ptr<SurfacePair> oriented_;  ///< with viewpoints, after a fallback search
  std::unique_ptr<CandidateSet> candidates_;
};

}  // namespace emtr
