#include "matching.h"

#include <pcl/kdtree/kdtree_flann.h>

#include <algorithm>
#include <tuple>

#include "pcl_cloud.h"

namespace emtr {
namespace {

using Signatures = pcl::PointCloud<pcl::FPFHSignature33>;

/// The points that have a descriptor, with their rows in the cloud.
struct Described {
  Signatures::Ptr signatures = pcl::make_shared<Signatures>();
  std::vector<std::int32_t> rows;
};

Described described(const Features& features) {
  Described out;
  const std::size_t n = features.descriptors.size() / kFeatureSize;
  for (std::size_t i = 0; i < n; ++i) {
    if (!features.valid(i)) continue;
    pcl::FPFHSignature33 signature;
    std::copy_n(&features.descriptors[i * kFeatureSize], kFeatureSize, signature.histogram);
    out.signatures->push_back(signature);
    out.rows.push_back(static_cast<std::int32_t>(i));
  }
  return out;
}

struct Nearest {
  std::vector<std::int32_t> index;
  std::vector<float> squared;
};

Nearest nearest(const Described& queries, const Described& points, int threads) {
  pcl::KdTreeFLANN<pcl::FPFHSignature33> tree;
  tree.setInputCloud(points.signatures);
  const auto n = static_cast<std::int64_t>(queries.rows.size());
  Nearest out{std::vector<std::int32_t>(queries.rows.size()),
              std::vector<float>(queries.rows.size())};
#pragma omp parallel num_threads(threads)
  {
    pcl::Indices index(1);
    std::vector<float> squared(1);
#pragma omp for schedule(dynamic, 64)
    for (std::int64_t i = 0; i < n; ++i) {
      const auto k = static_cast<std::size_t>(i);
      tree.nearestKSearch((*queries.signatures)[k], 1, index, squared);
      out.index[k] = index[0];
      out.squared[k] = squared[0];
    }
  }
  return out;
}

}  // namespace

std::vector<Correspondence> match(const Features& source, const Features& target, std::size_t most,
                                  int threads) {
  const Described s = described(source), t = described(target);
  if (s.rows.empty() || t.rows.empty()) return {};
  const Nearest forward = nearest(s, t, threads), backward = nearest(t, s, threads);

  std::vector<std::tuple<float, std::int32_t, std::int32_t>> mutual;
  for (std::size_t i = 0; i < s.rows.size(); ++i) {
    const auto j = static_cast<std::size_t>(forward.index[i]);
    if (backward.index[j] == static_cast<std::int32_t>(i))
      mutual.emplace_back(forward.squared[i], s.rows[i], t.rows[j]);
  }
  std::sort(mutual.begin(), mutual.end());
  mutual.resize(std::min(mutual.size(), most));
  std::vector<Correspondence> out;
  for (const auto& [distance, i, j] : mutual) out.push_back({i, j});
  return out;
}

}  // namespace emtr
