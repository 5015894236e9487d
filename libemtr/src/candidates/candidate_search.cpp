#include "candidates/candidate_search.h"

#include "candidates/fallback_search.h"
#include "ranking/given_viewpoints.h"

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
}

void CandidateSearch::run_fallback_search() {
  const GivenViewpoints given(settings_, pair_.normalization);
  const Viewpoints source = viewpoints(surfaces_.source(), given.source);
  const Viewpoints target = viewpoints(surfaces_.target(), given.target);
  const auto seeds =
      admissible(find_fallback_seeds(pair_, source, target, settings_, kernels_, threads_), prior_);
  auto oriented = std::make_unique<SurfacePair>(
      surfaces_.shared_source(), surfaces_.shared_target(), source, target, kernels_);
  auto candidates = std::make_unique<CandidateSet>(*oriented, prior_);
  ThreadTeam::with(threads_, [&](ThreadTeam& team) {
    std::vector<Rigid> all =
        candidates->shortlist(seeds, static_cast<std::size_t>(settings_.fallback_candidates), team);
    for (const Candidate& c : candidates_->ranked()) all.push_back(c.pose);
    candidates->add(all, team);
  });
  candidates_ = std::move(candidates);  // now, and not in part when it is cancelled before
  oriented_ = std::move(oriented);
}

Viewpoints CandidateSearch::viewpoints(const Surface& surface,
                                       const std::optional<Viewpoint>& given) const {
  if (!settings_.free_space) return {};
  return given ? given_viewpoint(surface, *given, kernels_)
               : estimate_viewpoints(surface, kernels_);
}

}  // namespace emtr
