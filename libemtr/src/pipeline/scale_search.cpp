#include "pipeline/scale_search.h"

#include <algorithm>
#include <cmath>

#include "geometry/pose_distance.h"
#include "pipeline/search_stages.h"
#include "pipeline/solve.h"
#include "refinement/similarity_refinement.h"
#include "settings/choices.h"
#include "util/error.h"

namespace emtr {
namespace {

// Octaves. Of right matches at the right scale a third is lost at a quarter octave beside it, and
// two thirds at half an octave; a pose is found up to a quarter beside.
constexpr double kMatchingStep = 0.5, kSearchStep = 0.25;
constexpr double kNarrow = 0.7;     // of such a range the middle has half of the matches anywhere
constexpr double kSearched = 0.04;  // a scale so near to one that was looked at is not looked at
constexpr std::size_t kPeaksNear = 3, kPeaksEverywhere = 6;
constexpr std::size_t kPosesOfScale = 2;
constexpr double kDistinctScale = 0.05;  // of the logarithm

/// Settings for a quick look: those of preset "fast" and one search only.
Settings quick(Settings settings) {
  const Settings fast = preset("fast");
  settings.dense_points = std::min(settings.dense_points, fast.dense_points);
  if (settings.seeds > 0) {  // else the swarms find the pose alone
    settings.iterations = std::min(settings.iterations, fast.iterations);
    settings.population = std::min(settings.population, fast.population);
  }
  settings.injected_seeds = std::min(settings.injected_seeds, fast.injected_seeds);
  settings.candidates = std::max(1, std::min(settings.candidates, fast.candidates));
  settings.rivals = 0;
  return settings;
}

/// Returns octaves from one end of the range to the other.
std::vector<double> even_steps(const ScaleRange& range, double step) {
  const auto count = static_cast<std::size_t>(std::ceil((range.highest - range.lowest) / step));
  std::vector<double> out(count + 1);
  for (std::size_t i = 0; i <= count; ++i)
    out[i] = std::min(range.lowest + static_cast<double>(i) * step, range.highest);
  return out;
}

std::unique_ptr<Neighbors> near_source(const SurfacePair& surfaces, const Kernels& kernels) {
  const auto leaf = static_cast<float>(surfaces.source().leaf);
  const auto radius = static_cast<float>(coarse_refinement().first_scale) * leaf;
  return make_neighbors(surfaces.source().points, radius, 1e4, kernels);
}

}  // namespace

bool is_same_scale(double a, double b) { return std::abs(std::log(a / b)) <= kDistinctScale; }

Settings settings_at_scale(const Settings& settings, double scale) {
  Settings out = settings;
  out.scale = static_cast<std::int32_t>(ScaleSearched::Fixed);
  out.scale_minimum = out.scale_maximum = 1;
  for (double& c : out.viewpoint_source) c *= scale;
  return out;
}

ScaleSearch::ScaleSearch(const InputCloud& source, const InputCloud& target,
                         const ScaleRange& range, const Settings& settings,
                         CancellationToken& token)
    : source_(source),
      target_(target),
      range_(range),
      settings_(quick(settings)),
      token_(token),
      gamma_(range.lowest, range.highest) {}

void ScaleSearch::search_near() {
  if (range_.highest - range_.lowest <= kNarrow) {
    match_at((range_.lowest + range_.highest) / 2);
    search_at_peaks(1);
    return;
  }
  for (const double octaves : {0.0, -kMatchingStep, kMatchingStep})
    match_at(std::clamp(octaves, range_.lowest, range_.highest));
  search_at_peaks(kPeaksNear);
}

void ScaleSearch::search_everywhere() {
  for (const double x : even_steps(range_, kMatchingStep)) match_at(x);
  search_at_peaks(kPeaksEverywhere);
  for (const double x : even_steps(range_, kSearchStep)) search_at(range_.scale(x));
}

/// Has task gamma hear the matches of the source at this scale.
void ScaleSearch::match_at(double octaves) {
  if (!settings_.task_gamma) return;
  const auto near = [&](double other) { return std::abs(other - octaves) < kMatchingStep / 2; };
  if (std::any_of(matched_.begin(), matched_.end(), near)) return;
  matched_.push_back(octaves);
  const double scale = range_.scale(octaves);
  InputCloud source{nullptr, source_.preprocessed->rescaled(scale)},
      target{nullptr, target_.preprocessed};
  const Settings settings = settings_at_scale(settings_, scale);
  try {
    const auto problem = make_problem(source, target, settings, token_, Stages::Matches);
    if (problem->stopped) throw Cancelled();
    const auto& matches = problem->correspondences;
    if (matches.size() < 3) return;
    gamma_.add({problem->matched_source().select(rows_of(matches, &Correspondence::source)),
                problem->matched_target().select(rows_of(matches, &Correspondence::target))},
               problem->downsampled.leaf_dense, octaves, kMatchingStep, thread_count(settings));
  } catch (const Error& error) {
    // At one leaf for both, a cloud can vanish that is small beside the other.
    if (error.status() != EMTR_ERROR_CLOUD) throw;
  }
}

std::vector<double> ScaleSearch::likely_scales(std::size_t count) const {
  std::vector<double> out;
  for (const TaskGamma::Peak& peak : gamma_.peaks(count)) out.push_back(range_.scale(peak.octaves));
  return out;
}

void ScaleSearch::search_at_peaks(std::size_t count) {
  for (const TaskGamma::Peak& peak : gamma_.peaks(count)) search_at(range_.scale(peak.octaves));
}

void ScaleSearch::search_at(double scale) {
  const double octaves = range_.octaves(scale);
  const auto near = [&](double other) { return std::abs(other - octaves) < kSearched; };
  if (std::any_of(searched_.begin(), searched_.end(), near)) return;
  searched_.push_back(octaves);
  InputCloud source{nullptr, source_.preprocessed->rescaled(scale)},
      target{nullptr, target_.preprocessed};
  std::unique_ptr<const Problem> made;
  try {
    made =
        make_problem(source, target, settings_at_scale(settings_, scale), token_, Stages::Needed);
  } catch (const Error& error) {
    if (error.status() != EMTR_ERROR_CLOUD) throw;  // as above
    return;
  }
  const Problem& problem = *made;
  if (problem.stopped) throw Cancelled();
  const Solution found = search_candidates(problem, token_);
  const auto near_of_source = near_source(*problem.surfaces, problem.kernels);
  const SimilarityRefinement refinement(
      problem.surfaces->shared_source(), problem.surfaces->shared_target(), *near_of_source,
      problem.surfaces->near_target(), coarse_refinement(), problem.kernels);
  SurfaceFit::Scratch scratch;
  for (const Candidate& candidate :
       suppress_non_maxima(found.candidates->ranked(), kDistinctPose, kPosesOfScale)) {
    const SimilarityFit fit = refinement({1, candidate.pose}, problem.prior.get());
    const SurfaceFitValue value =
        problem.surfaces->ranking().fit().evaluate(fit.similarity, 1, scratch);
    Similarity similarity = problem.pair.normalization.to_user(fit.similarity);
    similarity.scale *= scale;
    add({similarity, std::sqrt(value.score_source * value.score_target)});
  }
}

/// Tells whether two hypotheses are one answer, found twice.
bool ScaleSearch::is_same(const Similarity& a, const Similarity& b) const {
  if (!is_same_scale(a.scale, b.scale)) return false;
  const auto moved = [&](const Similarity& similarity) {
    Rigid out = similarity.pose;
    out.t = similarity * Eigen::Vector3d::Map(source_.preprocessed->center) /
            target_.preprocessed->radius;
    return out;
  };
  return is_same_pose(moved(a), moved(b), kDistinctPose);
}

void ScaleSearch::add(const ScaleHypothesis& hypothesis) {
  const auto known = std::find_if(ranked_.begin(), ranked_.end(), [&](const auto& other) {
    return is_same(other.similarity, hypothesis.similarity);
  });
  if (known == ranked_.end())
    ranked_.push_back(hypothesis);
  else if (hypothesis.score > known->score)
    *known = hypothesis;
  std::stable_sort(ranked_.begin(), ranked_.end(),
                   [](const auto& a, const auto& b) { return a.score > b.score; });
}

}  // namespace emtr
