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

  /// Adds poses as they are, the best of `many`, and the rivals of the best of all: see
  /// candidates/rivals. A verdict may only be sure once they have been looked at.
  void add(const std::vector<Rigid>& poses, const std::vector<Rigid>& many);

  /// Searches again with more keypoints and normals that face the sensors.
  void run_fallback_search();
  bool used_fallback_search() const { return used_fallback_search_; }

  const std::vector<Candidate>& ranked() const { return candidates_->ranked(); }
  const CandidateSet& candidates() const { return *candidates_; }

  /// Puts a candidate that something else than the score has chosen before all others.
  void put_first(const Candidate& candidate) { candidates_->put_first(candidate); }

 private:
  void add_rivals(CandidateSet& candidates) const;
  std::optional<Viewpoint> orientation(const Surface& surface,
                                       const std::optional<Viewpoint>& known) const;

  const NormalizedPair& pair_;
  const SurfacePair& surfaces_;
  const Settings& settings_;
  const Kernels& kernels_;
  const Prior* prior_;
  const int threads_;
  bool used_fallback_search_ = false;
  std::unique_ptr<CandidateSet> candidates_;
};

}  // namespace emtr
