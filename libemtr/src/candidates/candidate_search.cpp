#include "candidates/candidate_search.h"

#include "ranking/given_viewpoints.h"
#include "candidates/fallback_search.h"

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
      candidate_set_(std::make_unique<CandidateSet>(surfaces, prior)) {}

std::vector<Rigid> CandidateSearch::shortlist(const std::vector<Seed>& seeds) const {
  std::vector<Rigid> poses, out;
  for (const Seed& seed : seeds) poses.push_back(seed.pose);
  ThreadTeam::with(threads_, [&](ThreadTeam& team) {
    out = candidate_set_->shortlist(admissible(poses, prior_),
                           static_cast<std::size_t>(settings_.candidates), team);
  });
  return out;
}

void CandidateSearch::add(const std::vector<Rigid>& poses, const std::vector<Rigid>& many) {
  ThreadTeam::with(threads_, [&](ThreadTeam& team) {
    std::vector<Rigid> all =
        candidate_set_->shortlist(many, static_cast<std::size_t>(settings_.candidates), team);
    all.insert(all.end(), poses.begin(), poses.end());
    candidate_set_->add(all, team);
  });
}

void CandidateSearch::run_fallback_search() {
  const GivenViewpoints given(settings_, pair_.normalization);
  const Viewpoints of_source = viewpoints(surfaces_.source(), given.source);
  const Viewpoints of_target = viewpoints(surfaces_.target(), given.target);
  const auto seeds = admissible(
      fallback_seeds_of(pair_, of_source, of_target, settings_, kernels_, threads_), prior_);
  auto oriented = std::make_unique<SurfacePair>(surfaces_.source(), surfaces_.target(), of_source,
                                             of_target, kernels_);
  auto candidate_set = std::make_unique<CandidateSet>(*oriented, prior_);
  ThreadTeam::with(threads_, [&](ThreadTeam& team) {
    std::vector<Rigid> all =
        candidate_set->shortlist(seeds, static_cast<std::size_t>(settings_.fallback_candidates), team);
    for (const Candidate& c : candidate_set_->ranked()) all.push_back(c.pose);
    candidate_set->add(all, team);
  });
  candidate_set_ = std::move(candidate_set);  // now, and not in part when it is stopped before
  oriented_ = std::move(oriented);
}

Viewpoints CandidateSearch::viewpoints(const Surface& surface,
                                       const std::optional<Viewpoint>& given) const {
  if (!settings_.free_space) return {};
  return given ? given_viewpoint(surface, *given, kernels_)
               : estimate_viewpoints(surface, kernels_);
}

}  // namespace emtr
