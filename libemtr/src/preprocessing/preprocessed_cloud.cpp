#include "preprocessing/preprocessed_cloud.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <optional>
#include <utility>

#include "neighbors/resolution.h"
#include "neighbors/scattered_points.h"
#include "util/cancellation.h"

namespace emtr {

namespace {

constexpr std::size_t kSmall = 3000;  // points: in a larger cloud outliers do no harm

template <class Wanted>
std::vector<std::int64_t> rows_of(const CloudReader& reader, const Wanted& wanted) {
  std::vector<std::int64_t> out;
  for (std::size_t block = 0; block < reader.blocks(); ++block) {
    check_cancelled();
    reader.each_finite(block, [&](std::size_t i, const double* p) {
      if (wanted(p)) out.push_back(static_cast<std::int64_t>(block * CloudReader::kBlock + i));
    });
  }
  return out;
}

bool any_valid(const Cloud& normals) {
  return std::any_of(normals.x.begin(), normals.x.end(), [](float x) { return x == x; });
}

}  // namespace

PreprocessedCloud::PreprocessedCloud(const emtr_cloud& cloud, const std::string& name, int threads)
    : title_(name.empty() ? "cloud" : name + " cloud") {
  CloudReader reader(cloud, title_);
  if (reader.count() <= kDownsampledAbove) threads = 1;  // done sooner than other threads wake up
  const Extent extent =
      measure_extent(reader, title_, threads, cloud.keep_points ? kMatchedPoints : kSurfacePoints);
  strays = extent.strays;
  count = extent.count + strays;
  dropped = reader.count() - count;
  const CloudReader all = reader;
  if (extent.without_strays) reader.keep_within(*extent.without_strays);
  std::copy_n(extent.center, 3, center);
  radius = extent.radius;
  std::optional<NormalReader> directions;
  if (cloud.normals)
    directions.emplace(emtr_cloud{cloud.normals, cloud.count, cloud.normal_stride, cloud.scalar},
                       title_ + "'s normals");
  const std::optional<ColorReader> looks = ColorReader::of(cloud, title_);
  const PointData data{directions ? &*directions : nullptr, looks ? &*looks : nullptr};
  BasePoints made = read_base_points(reader, data, extent, threads);
  base = std::move(made.points);
  normals = std::move(made.normals);
  colors = std::move(made.colors);
  if (looks) color_kind = looks->kind();
  if (directions && !any_valid(normals))
    throw Error(
        EMTR_ERROR_ARGUMENT,
        title_ +
            ": normals are given, but no finite point has one that is finite and has a length");
  keypoints = read_keypoints(cloud, reader, extent, title_);
  whole_ = extent.count <= kDownsampledAbove;
  if (!whole_ && cloud.keep_points)
    all_points_ = read_all_points(reader, {}, extent, threads).points;
  if (!whole_ && !cloud.keep_points) return;
  if (dropped || strays) finite_ = rows_of(reader, [](const double*) { return true; });
  if (strays)
    strays_ = rows_of(all, [&](const double* p) { return !extent.without_strays->contains(p); });
  if (whole_ && base.size() <= kSmall) leave_out_scattered();
}

void PreprocessedCloud::leave_out_scattered() {
  const std::vector<std::size_t> kept = rows_on_surface(base);
  if (kept.size() == base.size() || kept.size() < kSurfacePoints) return;
  if (finite_.empty()) {
    finite_.resize(base.size());
    std::iota(finite_.begin(), finite_.end(), std::int64_t{0});
  }
  std::vector<std::int64_t> rows;
  rows.reserve(kept.size());
  for (const std::size_t row : kept) rows.push_back(finite_[row]);
  std::set_difference(finite_.begin(), finite_.end(), rows.begin(), rows.end(),
                      std::back_inserter(strays_));
  std::sort(strays_.begin(), strays_.end());
  strays += base.size() - kept.size();
  finite_ = std::move(rows);
  base = base.select(kept);
  if (normals.size()) normals = normals.select(kept);
  if (colors.size()) colors = colors.select(kept);
}

bool PreprocessedCloud::find(std::size_t row, float p[3]) const {
  const Cloud& all = whole_ ? base : all_points_;
  if (all.size() == 0)
    throw Error(EMTR_ERROR_ARGUMENT, title_ +
                                         ": preprocessed without keep_points, expected it for "
                                         "correspondences of a cloud of more than " +
                                         std::to_string(kDownsampledAbove) + " points");
  if (!finite_.empty()) {
    const auto at =
        std::lower_bound(finite_.begin(), finite_.end(), static_cast<std::int64_t>(row));
    if (at == finite_.end() || *at != static_cast<std::int64_t>(row)) return false;
    row = static_cast<std::size_t>(at - finite_.begin());
  }
  p[0] = all.x[row];
  p[1] = all.y[row];
  p[2] = all.z[row];
  return true;
}

bool PreprocessedCloud::is_stray(std::size_t row) const {
  return std::binary_search(strays_.begin(), strays_.end(), static_cast<std::int64_t>(row));
}

double PreprocessedCloud::spacing() const {
  constexpr std::size_t enough = 2000;  // for a mean to about one percent
  double known = spacing_.load();
  if (known < 0) {
    known = mean_spacing(base, enough);
    spacing_.store(known);
  }
  return known;
}

PreprocessedCloudPtr PreprocessedCloud::rescaled(double factor) const {
  const auto out = std::make_shared<PreprocessedCloud>(*this);
  for (double& c : out->center) c *= factor;
  out->radius *= factor;
  return out;
}

}  // namespace emtr
