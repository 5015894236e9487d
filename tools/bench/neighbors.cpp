// Nanoseconds a look-up of the nearest neighbour, truncated where the M-estimator is flat:
// pcl::KdTreeFLANN, nanoflann and the candidate grid with each kernel, for clouds of 600 to 100000
// points, in random poses as a swarm begins with, and aligned as it ends.
#include "neighbors/neighbors.h"

#include <benchmark/benchmark.h>

#include <Eigen/Geometry>
#include <cmath>
#include <nanoflann.hpp>
#include <random>
#include <string>
#include <vector>

#include "features/kdtree_neighbors.h"

namespace {

using emtr::Cloud;

constexpr std::size_t kPoses = 40;
constexpr double kScale = 1.2;  // radius of the search, leaves

/// A bumpy ball of about unit radius, evenly covered by n points: what a thinned scan looks like.
Cloud surface(std::size_t n, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> jitter(-0.3, 0.3);
  const double step = std::sqrt(4 * M_PI / static_cast<double>(n));
  Cloud cloud;
  for (std::size_t i = 0; i < n; ++i) {
    const double z = 1 - (2 * static_cast<double>(i) + 1) / static_cast<double>(n);
    const double a = 2.399963 * static_cast<double>(i) + jitter(random) * step;
    const Eigen::Vector3d u(std::sqrt(1 - z * z) * std::cos(a), std::sqrt(1 - z * z) * std::sin(a),
                            z);
    const Eigen::Vector3d p = u * (0.8 + 0.15 * std::sin(5 * u.x()) * std::cos(4 * u.y()));
    cloud.x.push_back(static_cast<float>(p.x()));
    cloud.y.push_back(static_cast<float>(p.y()));
    cloud.z.push_back(static_cast<float>(p.z()));
  }
  return cloud;
}

float leaf_of(std::size_t n) {
  return static_cast<float>(0.8 * std::sqrt(4 * M_PI / static_cast<double>(n)));
}

/// The other scan's points in each of the poses.
std::vector<Cloud> queries(std::size_t n, bool aligned) {
  const Cloud cloud = surface(n, 2);
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> box(-0.5, 0.5);
  std::vector<Cloud> out(kPoses, cloud);
  for (Cloud& moved : out) {
    if (aligned) continue;
    const Eigen::Quaterniond q(normal(random), normal(random), normal(random), normal(random));
    const Eigen::Matrix3d R = q.normalized().toRotationMatrix();
    const Eigen::Vector3d t(box(random), box(random), box(random));
    for (std::size_t i = 0; i < n; ++i) {
      const Eigen::Vector3f p =
          (R * Eigen::Vector3d(cloud.x[i], cloud.y[i], cloud.z[i]) + t).cast<float>();
      moved.x[i] = p.x();
      moved.y[i] = p.y();
      moved.z[i] = p.z();
    }
  }
  return out;
}

/// Times answer(queries, out) over all poses; a rate of items is look-ups a second.
template <class Answer>
void time_look_ups(benchmark::State& state, std::size_t n, bool aligned, Answer answer) {
  const std::vector<Cloud> poses = queries(n, aligned);
  std::vector<float> out(n);
  std::size_t pose = 0;
  for (auto _ : state) {
    answer(poses[pose++ % kPoses], out);
    benchmark::DoNotOptimize(out.data());
  }
  state.counters["look_up"] =
      benchmark::Counter(static_cast<double>(n), benchmark::Counter::kIsIterationInvariantRate |
                                                     benchmark::Counter::kInvert);
}

struct Adaptor {
  const Cloud& cloud;
  std::size_t kdtree_get_point_count() const { return cloud.size(); }
  float kdtree_get_pt(std::size_t i, std::size_t axis) const {
    return (axis == 0 ? cloud.x : axis == 1 ? cloud.y : cloud.z)[i];
  }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

void by_nanoflann(benchmark::State& state, std::size_t n, bool aligned) {
  using Tree =
      nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, Adaptor>, Adaptor, 3>;
  const Cloud cloud = surface(n, 1);
  const Adaptor adaptor{cloud};
  Tree tree(3, adaptor, nanoflann::KDTreeSingleIndexAdaptorParams(10));
  tree.buildIndex();
  time_look_ups(state, n, aligned, [&](const Cloud& q, std::vector<float>& out) {
    for (std::size_t i = 0; i < q.size(); ++i) {
      const float point[3] = {q.x[i], q.y[i], q.z[i]};
      std::uint32_t index;
      tree.knnSearch(point, 1, &index, &out[i]);
    }
  });
}

void by_structure(benchmark::State& state, std::size_t n, bool aligned,
                  const emtr::Kernels* kernels) {
  const Cloud cloud = surface(n, 1);
  const float radius = static_cast<float>(kScale) * leaf_of(n);
  const auto structure = kernels ? emtr::make_candidate_grid(cloud, radius, leaf_of(n), *kernels)
                                 : emtr::make_kdtree(cloud, radius);
  time_look_ups(state, n, aligned, [&](const Cloud& q, std::vector<float>& out) {
    structure->squared_distances(q.view(), out.data());
  });
}

void register_all() {
  for (const std::size_t n : {600u, 2000u, 5000u, 20000u, 100000u})
    for (const bool aligned : {false, true}) {
      const auto name = [&](const std::string& structure) {
        return structure + (aligned ? "/aligned/" : "/random/") + std::to_string(n);
      };
      const auto add = [&](const std::string& structure, auto run) {
        benchmark::RegisterBenchmark(name(structure).c_str(), run);
      };
      add("flann", [=](benchmark::State& s) { by_structure(s, n, aligned, nullptr); });
      add("nanoflann", [=](benchmark::State& s) { by_nanoflann(s, n, aligned); });
      if (n > 20000) continue;  // beyond, the grid's making costs more than it saves
      for (std::size_t i = 0; const emtr::Kernels* kernels = emtr::kernels_at(i); ++i)
        if (emtr::can_run(*kernels))
          add(std::string("grid_") + kernels->name,
              [=](benchmark::State& s) { by_structure(s, n, aligned, kernels); });
    }
}

}  // namespace

int main(int argc, char** argv) {
  register_all();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
