// Measures the time of a nearest-neighbor query, truncated where the M-estimator is flat, and the
// time to make the structure: pcl::KdTreeFLANN, nanoflann, and the candidate grid and voxel cells
// with each kernel. Clouds have 600 to 100000 points, in random poses as a swarm begins with, and
// aligned as it ends.
#include "neighbors/neighbors.h"

#include <benchmark/benchmark.h>

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <memory>
#include <nanoflann.hpp>
#include <random>
#include <string>
#include <vector>

#include "neighbors/kdtree_neighbors.h"

namespace {

using emtr::Cloud;

constexpr std::size_t kPoses = 40;
constexpr double kScale = 1.2;  // radius of the search, leaves

/// A bumpy ball of about unit radius, evenly covered by n points: as in a downsampled scan.
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

/// Times answer(queries, out) over all poses; the rate of items is queries a second.
template <class Answer>
void time_queries(benchmark::State& state, std::size_t n, bool aligned, Answer answer) {
  const std::vector<Cloud> poses = queries(n, aligned);
  std::vector<float> out(n);
  std::size_t pose = 0;
  for (auto _ : state) {
    answer(poses[pose++ % kPoses], out);
    benchmark::DoNotOptimize(out.data());
  }
  state.counters["query"] =
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

using Tree =
    nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, Adaptor>, Adaptor, 3>;

std::unique_ptr<Tree> make_nanoflann(const Adaptor& adaptor) {
  auto tree = std::make_unique<Tree>(3, adaptor, nanoflann::KDTreeSingleIndexAdaptorParams(10));
  tree->buildIndex();
  return tree;
}

void by_nanoflann(benchmark::State& state, std::size_t n, bool aligned) {
  const Cloud cloud = surface(n, 1);
  const Adaptor adaptor{cloud};
  const auto tree = make_nanoflann(adaptor);
  time_queries(state, n, aligned, [&](const Cloud& q, std::vector<float>& out) {
    for (std::size_t i = 0; i < q.size(); ++i) {
      const float point[3] = {q.x[i], q.y[i], q.z[i]};
      std::uint32_t index;
      tree->knnSearch(point, 1, &index, &out[i]);
    }
  });
}

/// Makes a structure of a cloud, with a radius and a leaf.
using Make = std::function<std::unique_ptr<emtr::Neighbors>(const Cloud&, float, float)>;

void by_structure(benchmark::State& state, std::size_t n, bool aligned, const Make& make) {
  const Cloud cloud = surface(n, 1);
  const auto structure = make(cloud, static_cast<float>(kScale) * leaf_of(n), leaf_of(n));
  time_queries(state, n, aligned, [&](const Cloud& q, std::vector<float>& out) {
    structure->squared_distances(q.view(), out.data());
  });
}

/// Times make(cloud), whatever it returns.
template <class MakeOne>
void time_making(benchmark::State& state, std::size_t n, MakeOne make) {
  const Cloud cloud = surface(n, 1);
  for (auto _ : state) {
    const auto made = make(cloud);
    benchmark::DoNotOptimize(made.get());
  }
  state.counters["a_point"] =
      benchmark::Counter(static_cast<double>(n), benchmark::Counter::kIsIterationInvariantRate |
                                                     benchmark::Counter::kInvert);
}

template <class Run>
void add(const std::string& structure, const std::string& what, std::size_t n, Run run) {
  const std::string name = structure + "/" + what + "/" + std::to_string(n);
  benchmark::RegisterBenchmark(name.c_str(), run)->Unit(benchmark::kMicrosecond);
}

void add_structure(const std::string& name, std::size_t n, const Make& make) {
  for (const bool aligned : {false, true})
    add(name, aligned ? "aligned" : "random", n,
        [=](benchmark::State& s) { by_structure(s, n, aligned, make); });
}

void add_making(const std::string& name, std::size_t n, const Make& make) {
  add(name, "make", n, [=](benchmark::State& s) {
    time_making(s, n, [&](const Cloud& cloud) {
      return make(cloud, static_cast<float>(kScale) * leaf_of(n), leaf_of(n));
    });
  });
}

void register_all() {
  const Make flann = [](const Cloud& cloud, float radius, float) {
    return emtr::make_kdtree(cloud, radius);
  };
  const auto grid = [](const emtr::Kernels& kernels) -> Make {
    return [&](const Cloud& cloud, float radius, float leaf) {
      return emtr::make_candidate_grid(cloud, radius, leaf, kernels);
    };
  };
  const auto voxels = [](const emtr::Kernels& kernels) -> Make {
    return [&](const Cloud& cloud, float radius, float) {
      return emtr::make_voxel_cells(cloud, radius, kernels);
    };
  };
  const emtr::Kernels& any = *emtr::kernels_at(0);  // making uses none
  for (const std::size_t n : {600u, 2000u, 5000u, 20000u, 100000u}) {
    add_making("flann", n, flann);
    add("nanoflann", "make", n, [=](benchmark::State& s) {
      time_making(s, n, [](const Cloud& cloud) {
        const Adaptor adaptor{cloud};
        return make_nanoflann(adaptor);
      });
    });
    add_making("grid", n, grid(any));
    add_making("voxels", n, voxels(any));
    add_structure("flann", n, flann);
    for (const bool aligned : {false, true})
      add("nanoflann", aligned ? "aligned" : "random", n,
          [=](benchmark::State& s) { by_nanoflann(s, n, aligned); });
    for (std::size_t i = 0; const emtr::Kernels* kernels = emtr::kernels_at(i); ++i)
      if (emtr::can_run(*kernels)) {
        add_structure(std::string("grid_") + kernels->name, n, grid(*kernels));
        add_structure(std::string("voxels_") + kernels->name, n, voxels(*kernels));
      }
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
