#include "search.h"

#include "../ranking/given_viewpoints.h"
#include "escalation.h"

namespace emtr {

CandidateSearch::CandidateSearch(const NormalisedPair& pair, const Surfaces& surfaces,
                                 const Settings& settings, const Kernels& kernels,
                                 const Prior* prior)
    : pair_(pair),
      surfaces_(surfaces),
      settings_(settings),
      kernels_(kernels),
      prior_(prior),
      threads_(thread_count(settings)),
      pool_(std::make_unique<Pool>(surfaces, prior)) {}

std::vector<Rigid> CandidateSearch::shortlist(const std::vector<Seed>& seeds) const {
  std::vector<Rigid> poses, out;
  for (const Seed& seed : seeds) poses.push_back(seed.pose);
  Team::with(threads_, [&](Team& team) {
    out = pool_->shortlist(admissible(poses, prior_),
                           static_cast<std::size_t>(settings_.candidates), team);
  });
  return out;
}

void CandidateSearch::add(const std::vector<Rigid>& poses, const std::vector<Rigid>& many) {
  Team::with(threads_, [&](Team& team) {
    std::vector<Rigid> all =
        pool_->shortlist(many, static_cast<std::size_t>(settings_.candidates), team);
    all.insert(all.end(), poses.begin(), poses.end());
    pool_->add(all, team);
  });
}

void CandidateSearch::escalate() {
  const GivenViewpoints given(settings_, pair_.frame);
  const Viewpoints of_source = viewpoints(surfaces_.source(), given.source);
  const Viewpoints of_target = viewpoints(surfaces_.target(), given.target);
  const auto seeds = admissible(
      escalated_seeds(pair_, of_source, of_target, settings_, kernels_, threads_), prior_);
  auto oriented = std::make_unique<Surfaces>(surfaces_.source(), surfaces_.target(), of_source,
                                             of_target, kernels_);
  auto pool = std::make_unique<Pool>(*oriented, prior_);
  Team::with(threads_, [&](Team& team) {
    std::vector<Rigid> all =
        pool->shortlist(seeds, static_cast<std::size_t>(settings_.escalation_candidates), team);
    for (const Candidate& c : pool_->ranked()) all.push_back(c.pose);
    pool->add(all, team);
  });
  pool_ = std::move(pool);  // now, and not in part when it is stopped before
  oriented_ = std::move(oriented);
}

Viewpoints CandidateSearch::viewpoints(const Surface& surface,
                                       const std::optional<Viewpoint>& given) const {
  if (!settings_.free_space) return {};
  return given ? given_viewpoint(surface, *given, kernels_)
               : estimate_viewpoints(surface, kernels_);
}

}  // namespace emtr
