#include <algorithm>
#include <cmath>

#include "geometry/pose_distance.h"
#include "pipeline/search_stages.h"
#include "refinement/unconstrained_motion.h"
#include "settings/choices.h"
#include "util/thread_team.h"
#include "verdict/color_verdict.h"

namespace emtr {
namespace {

constexpr double kWorthALook = 0.2;                 // of the best score
constexpr std::size_t kMostStarts = 4;              // of searches along unconstrained directions
constexpr std::size_t kMostFound = 6;               // poses of each
constexpr std::size_t kByScore = 4, kByColor = 10;  // candidates that are refined
// A refined pose may have so much of the evidence of its start: which point is the nearest is
// chance.
constexpr double kKept = 0.9;
// Closer than this, two refined poses are one answer.
constexpr PoseDistance kSameAnswer = {2 * kDegree, 0.02};

/// Tells whether the shape of the clouds leaves the pose open.
bool is_open(const Problem& problem, const Solution& found) {
  return found.refined.unconstrained > 0 ||
         found.confidence->probability < problem.settings.minimum_confidence;
}

/// Poses that may be the answer, and among how many they were found.
struct Poses {
  std::vector<Rigid> poses;
  std::size_t looked_at = 0;
};

std::vector<Rigid> promising(const Solution& found) {
  const std::vector<Candidate>& ranked = found.candidates->ranked();
  std::vector<Rigid> out{*found.pose};
  for (const Candidate& candidate : ranked)
    if (candidate.score > kWorthALook * ranked.front().score) out.push_back(candidate.pose);
  return out;
}

/// Adds what the colors find along the unconstrained directions of the best poses that differ by
/// more than these.
void search_unconstrained(const Problem& problem, const Solution& found, Poses& out) {
  const HessianSpectrum& spectrum = found.refined.hessian_spectrum;
  if (!found.refined.succeeded || spectrum.unconstrained == 0) return;
  std::vector<Rigid> starts;
  for (const Rigid& pose : out.poses) {
    const auto same = [&](const Rigid& known) {
      return is_same_but_unconstrained(pose, known, spectrum);
    };
    if (std::none_of(starts.begin(), starts.end(), same)) starts.push_back(pose);
    if (starts.size() == kMostStarts) break;
  }
  ThreadTeam::with(thread_count(problem.settings), [&](ThreadTeam& team) {
    for (const Rigid& start : starts) {
      const FoundByColor more = search_by_color(found.colors->levels, FreeMotions(spectrum, start),
                                                problem.prior.get(), kMostFound, team);
      for (const Rigid& pose : more.poses) out.poses.push_back(admissible_pose(problem, pose));
      out.looked_at += more.looked_at;
    }
  });
}

/// Returns the poses to refine: the first ones, which have the best scores, and those of the most
/// evidence.
std::vector<Rigid> select(const ColorCorrelation& colors, const std::vector<Rigid>& poses,
                          ThreadTeam& team) {
  std::vector<double> evidence(poses.size());
  std::vector<ColorCorrelation::Scratch> scratch(team.size());
  team.parallel(poses.size(), [&](std::size_t i, std::size_t thread) {
    evidence[i] = colors.evaluate(poses[i], scratch[thread]).evidence;
  });
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < poses.size(); ++i) order.push_back(i);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return evidence[a] > evidence[b]; });
  std::vector<Rigid> best,
      out(poses.begin(),
          poses.begin() + static_cast<std::ptrdiff_t>(std::min(kByScore, poses.size())));
  for (const std::size_t i : order) best.push_back(poses[i]);
  for (const Rigid& pose : suppress_non_maxima(best, kDuplicatePose, kByColor)) out.push_back(pose);
  return suppress_non_maxima(out, kSameAnswer, out.size());
}

struct Refinement {
  ColoredCandidate candidate;
  PhotometricResult result;
};

const Rigid& pose_of(const Refinement& refinement) { return refinement.candidate.candidate.pose; }

/// Refines a pose by shape and colors; keeps the start where that made the colors agree less.
Refinement refine_by_color(const Problem& problem, const Solution& found, const Rigid& start) {
  Ranking::Scratch ranking;
  ColorCorrelation::Scratch scratch;
  const ColorCorrelation& colors = found.colors->levels.fine();
  Refinement out;
  out.result = found.colors->refinement(start, problem.prior.get());
  Rigid pose = out.result.pose;
  ColorEvidence evidence = colors.evaluate_locally(pose, scratch);
  if (!out.result.succeeded || !is_same_pose(pose, start, kDistinctPose) ||
      colors.evaluate(pose, scratch).evidence < kKept * colors.evaluate(start, scratch).evidence) {
    out.result.succeeded = false;
    pose = start;
    evidence = colors.evaluate_locally(start, scratch);
  }
  out.candidate = {found.candidates->candidates().score(pose, ranking), evidence};
  return out;
}

std::vector<Refinement> refine_all(const Problem& problem, const Solution& found,
                                   const std::vector<Rigid>& poses, ThreadTeam& team) {
  std::vector<Refinement> out(poses.size());
  team.parallel(poses.size(), [&](std::size_t i, std::size_t) {
    out[i] = refine_by_color(problem, found, poses[i]);
  });
  std::stable_sort(out.begin(), out.end(), [](const Refinement& a, const Refinement& b) {
    return a.candidate.colors.evidence > b.candidate.colors.evidence;
  });
  return suppress_non_maxima(out, kSameAnswer, out.size());
}

/// Takes a refined pose, and what colors and shape together constrain.
void take(const Problem& problem, const Refinement& best, Solution& found) {
  const Rigid& pose = pose_of(best);
  Refined refined =
      refine(*found.fine, pose, problem.settings, problem.kernels, problem.prior.get());
  refined.pose = pose;
  if (best.result.succeeded) {
    refined.succeeded = true;
    const double leaf = found.fine->leaf();
    NormalEquations both = best.result.geometric;
    for (int k = 0; k < 21; ++k) both.H[k] += leaf * leaf * best.result.photometric.H[k];
    refined.hessian_spectrum = hessian_spectrum(both);
    refined.unconstrained =
        problem.prior ? unconstrained_within(refined.hessian_spectrum, problem.prior->limits(pose))
                      : refined.hessian_spectrum.unconstrained;
    double information[36];
    best.result.photometric.normal_matrix(information);
    for (int k = 0; k < 36; ++k) refined.information[k] += information[k];
  }
  found.refined = refined;
  found.pose = refined.pose;
  found.color_evidence = best.candidate.colors;
  found.used_colors = true;
}

}  // namespace

void resolve_by_colors(const Problem& problem, Solution& found) {
  if (!found.confidence || !have_comparable_colors(problem.pair)) return;
  if (!in_use(problem.settings.use_colors, is_open(problem, found))) return;
  const FineSurfaces& surfaces = fine(problem, found);
  if (!found.compared_colors)
    found.colors = compare_colors(problem.pair, surfaces, problem.kernels);
  found.compared_colors = true;
  if (!found.colors) return;

  Poses poses{promising(found), 0};
  search_unconstrained(problem, found, poses);
  std::vector<Refinement> refined;
  ThreadTeam::with(thread_count(problem.settings), [&](ThreadTeam& team) {
    refined =
        refine_all(problem, found, select(found.colors->levels.middle(), poses.poses, team), team);
  });
  std::vector<ColoredCandidate> candidates;
  candidates.reserve(refined.size());
  for (const Refinement& one : refined) candidates.push_back(one.candidate);
  const std::size_t looked_at = poses.looked_at + poses.poses.size();
  const ColorVerdict verdict = judge_by_colors(candidates, looked_at);
  // Along unconstrained directions the right pose is where the colors pull to as well; where they
  // agree by chance, the refinement leads away.
  const bool settled = !refined.empty() &&
                       (found.refined.unconstrained == 0 || refined[verdict.best].result.succeeded);
  if (verdict.decided && settled) {
    take(problem, refined[verdict.best], found);
    found.candidates->put_first(refined[verdict.best].candidate.candidate);
    found.moves_freely = false;
    believe(problem, {found.candidates->ranked().front()}, found);
    found.confidence->probability = std::min(found.confidence->probability, verdict.probability);
    return;
  }
  const Refinement own = refine_by_color(problem, found, *found.pose);
  found.color_evidence = own.candidate.colors;
  const bool proven = is_more_than_chance(own.candidate.colors.evidence, looked_at);
  if (problem.settings.use_colors == When::Always && proven && !is_open(problem, found))
    take(problem, own, found);
}

}  // namespace emtr
