#pragma once

#include <optional>

#include "pipeline/problem.h"
#include "pipeline/scale_range.h"
#include "pipeline/scale_search.h"
#include "pipeline/solution.h"

namespace emtr {

/// Returns the similarity that the user's correspondences agree on least by chance, at one of the
/// scales for which pairs of them vote; empty when they agree on none. Its score is the share of
/// the matches that are inliers.
std::optional<ScaleHypothesis> scale_of_matches(const InputCloud& source, const InputCloud& target,
                                                const ScaleRange& range, const Settings& settings);

/// Fits the similarity (normalized frame) to the inliers of a pose that the matches alone decide,
/// by least squares (Umeyama 1991): the rotation is that of the pose.
Similarity fit_similarity(const Problem& problem, const Rigid& pose);

}  // namespace emtr
