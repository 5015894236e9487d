#include "candidates/candidate_search.h"

#include <utility>

#include "candidates/fallback_search.h"
#include "candidates/plane_aligned_poses.h"
#include "candidates/rivals.h"
#include "ranking/visible_viewpoint.h"

namespace emtr {

CandidateSearch::CandidateSearch(const NormalizedPair& pair, const SurfacePair& surfaces,
                                 const Settings& settings, const Kernels& kernels,
                                 const Prior* prior)
    : pair_(pair),
      surfaces_(surfaces),
      settings_(settings),
      kernels_(kernels),
      prior_(prior),
      threads_(thread_count(settings)),
      candidates_(std::make_unique<CandidateSet>(surfaces, prior)) {}

std::vector<Rigid> CandidateSearch::shortlist(const std::vector<Seed>& seeds) const {
  std::vector<Rigid> poses, out;
  for (const Seed& seed : seeds) poses.push_back(seed.pose);
  ThreadTeam::with(threads_, [&](ThreadTeam& team) {
    out = candidates_->shortlist(admissible(poses, prior_),
                                 static_cast<std::size_t>(settings_.candidates), team);
  });
  return out;
}

void CandidateSearch::add(const std::vector<Rigid>& poses, const std::vector<Rigid>& many) {
  ThreadTeam::with(threads_, [&](ThreadTeam& team) {
    std::vector<Rigid> all =
        candidates_->shortlist(many, static_cast<std::size_t>(settings_.candidates), team);
    all.insert(all.end(), poses.begin(), poses.end());
    candidates_->add(all, team);
  });
  add_rivals(*candidates_);
}

void CandidateSearch::run_fallback_search() {
  std::optional<Viewpoint> source, target;
  parallel_for(2, threads_, [&](std::size_t i) {
    if (i == 0)
      source = orientation(surfaces_.source(), surfaces_.source_viewpoint());
    else
      target = orientation(surfaces_.target(), surfaces_.target_viewpoint());
  });
  const auto seeds =
      admissible(find_fallback_seeds(pair_, source, target, settings_, kernels_, threads_), prior_);
  auto candidates = std::make_unique<CandidateSet>(*candidates_);
  ThreadTeam::with(threads_, [&](ThreadTeam& team) {
    candidates->add(
        candidates->shortlist(seeds, static_cast<std::size_t>(settings_.fallback_candidates), team),
        team);
    // All of them: between two steps of rotation a quick score says too little.
    const auto most = static_cast<std::size_t>(settings_.plane_aligned_poses);
    candidates->add(admissible(plane_aligned_poses(surfaces_, most, kernels_, team), prior_), team);
  });
  add_rivals(*candidates);
  candidates_ = std::move(candidates);  // now, and not in part when it is cancelled before
  used_fallback_search_ = true;
}

void CandidateSearch::add_rivals(CandidateSet& candidates) const {
  if (!settings_.rivals) return;
  constexpr std::size_t kMostRivals = 8;  // of one kind; a rival below these is none
  ThreadTeam::with(threads_, [&](ThreadTeam& team) {
    const auto best = [&] { return candidates.ranked().front().pose; };
    const auto add = [&](const std::vector<Rigid>& rivals) {
      candidates.add(admissible(rivals, prior_), team, kMostRivals);
    };
    add(quarter_rotated_rivals(surfaces_, best()));
    add(rotated_rivals(surfaces_, best(), team));
    add(translated_rivals(surfaces_, best(), team));
  });
}

std::optional<Viewpoint> CandidateSearch::orientation(const Surface& surface,
                                                      const std::optional<Viewpoint>& known) const {
  if (!settings_.free_space) return std::nullopt;
  return known && known->trust == 1 ? known : estimate_visible_viewpoint(surface, kernels_);
}

}  // namespace emtr
