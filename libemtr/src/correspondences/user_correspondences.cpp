#include "correspondences/user_correspondences.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "util/cancellation.h"
#include "util/error.h"

namespace emtr {
namespace {

constexpr std::size_t kMinimumCount = 3;  // that determine a pose

std::vector<std::int32_t> distinct_rows(const std::vector<Correspondence>& correspondences,
                                        std::int32_t Correspondence::*side) {
  std::vector<std::int32_t> rows = rows_of(correspondences, side);
  std::sort(rows.begin(), rows.end());
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  return rows;
}

/// One side of the correspondences.
class Side {
 public:
  Side(const PreprocessedCloud& cloud, double scale, const char* name)
      : cloud_(cloud), factor_(cloud.radius / scale), name_(name) {}

  /// Returns false for a stray. Throws Error when the row does not exist or is not finite.
  bool takes(std::int32_t row, std::size_t pair) const {
    float p[3];
    const auto refuse = [&](const std::string& what) {
      throw Error(EMTR_ERROR_ARGUMENT, "correspondences: row " + std::to_string(pair) + ": " +
                                           name_ + " point " + std::to_string(row) + what);
    };
    if (row < 0 || static_cast<std::size_t>(row) >= cloud_.rows())
      refuse(", expected 0 to " + std::to_string(cloud_.rows() - 1));
    if (cloud_.find(static_cast<std::size_t>(row), p)) return true;
    if (!cloud_.is_stray(static_cast<std::size_t>(row))) refuse(" is not finite");
    return false;
  }

  /// Returns the points that the correspondences name.
  Keypoints named_points(const std::vector<Correspondence>& correspondences,
                         std::int32_t Correspondence::*side) const {
    Keypoints out;
    out.rows = distinct_rows(correspondences, side);
    out.points = points(out.rows);
    return out;
  }

  /// Returns the points of these rows.
  Cloud points(const std::vector<std::int32_t>& rows) const {
    Cloud out;
    out.resize(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      float p[3];
      cloud_.find(static_cast<std::size_t>(rows[i]), p);
      out.set(i, p);
    }
    return scale_cloud(out, factor_);
  }

 private:
  const PreprocessedCloud& cloud_;
  double factor_;
  std::string name_;
};

std::int32_t place_of(const std::vector<std::int32_t>& rows, std::int32_t row) {
  return static_cast<std::int32_t>(std::lower_bound(rows.begin(), rows.end(), row) - rows.begin());
}

}  // namespace

UserCorrespondences load_user_correspondences(const NormalizedPair& pair, const std::int32_t* rows,
                                              std::size_t count, std::size_t max_count) {
  const Side source(*pair.preprocessed_source, pair.normalization.scale, "source"),
      target(*pair.preprocessed_target, pair.normalization.scale, "target");
  std::set<std::pair<std::int32_t, std::int32_t>> known;
  std::vector<Correspondence> distinct;
  for (std::size_t i = 0; i < count; ++i) {
    check_cancelled_each(i, 10);
    const Correspondence match{rows[2 * i], rows[2 * i + 1]};
    const bool from = source.takes(match.source, i), to = target.takes(match.target, i);
    if (from && to && known.emplace(match.source, match.target).second) distinct.push_back(match);
  }
  if (distinct.size() < kMinimumCount)
    throw Error(EMTR_ERROR_ARGUMENT, "correspondences: " + std::to_string(distinct.size()) +
                                         " different ones, expected at least " +
                                         std::to_string(kMinimumCount));
  UserCorrespondences out;
  out.correspondences = select_evenly(distinct, max_count);
  out.keypoints.source = source.named_points(out.correspondences, &Correspondence::source);
  out.keypoints.target = target.named_points(out.correspondences, &Correspondence::target);
  for (Correspondence& match : out.correspondences)
    match = {place_of(out.keypoints.source.rows, match.source),
             place_of(out.keypoints.target.rows, match.target)};
  const std::vector<Correspondence> all = select_evenly(distinct, kMaximumMatches);
  out.matches.p = source.points(rows_of(all, &Correspondence::source));
  out.matches.q = target.points(rows_of(all, &Correspondence::target));
  out.named_source = distinct_rows(distinct, &Correspondence::source).size();
  out.named_target = distinct_rows(distinct, &Correspondence::target).size();
  return out;
}

std::vector<Correspondence> select_evenly(const std::vector<Correspondence>& all,
                                          std::size_t max_count) {
  if (all.size() <= max_count) return all;
  std::vector<Correspondence> out;
  for (std::size_t k = 0; k < max_count; ++k) out.push_back(all[k * all.size() / max_count]);
  return out;
}

}  // namespace emtr
