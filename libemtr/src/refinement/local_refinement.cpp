#include "refinement/local_refinement.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>

#include "util/error.h"
#include "refinement/constrained_step.h"
#include "geometry/small_motion.h"
#include "geometry/transform.h"

namespace emtr {
namespace {

constexpr std::size_t kBlock = 512;  // queries whose sums are one piece of work
/// Of the Levenberg-Marquardt kind, by the sum of weights: far below what a surface of any shape
/// holds, and enough for a step along what a plane or a sphere leaves free to stay small.
constexpr double kDamping = 1e-6;
/// Leaves: the cubes in which pairs are held to say the same. Larger ones change little, until
/// there are too few of them.
constexpr double kCluster = 3;

void require(bool holds, const char* what) {
  if (!holds) throw Error(EMTR_ERROR_ARGUMENT, std::string("polish: ") + what);
}

const LocalRefinementSettings& checked(const LocalRefinementSettings& s) {
  require(s.last_scale > 0 && s.first_scale >= s.last_scale && std::isfinite(s.first_scale),
          "expected 0 < last_scale <= first_scale");
  require(s.shrink > 0 && s.shrink < 1, "expected shrink in (0, 1)");
  require(s.reach > 0 && std::isfinite(s.reach), "expected a finite reach above 0");
  require(s.normal_gate >= 0 && s.normal_gate < 1, "expected normal_gate in [0, 1)");
  require(s.softness > 0 && s.softness < 1, "expected softness in (0, 1)");
  require(s.step > 0, "expected a step above 0");
  require(s.iterations >= 1, "expected 1 iteration or more");
  require(s.queries >= 1 && s.first_queries >= 1, "expected 1 query or more");
  require(s.minimum_inliers >= 6, "expected minimum_inliers of 6 or more");
  return s;
}

/// The Gauss-Newton step, of a pose that keeps to the prior.
Vector6 solve(const NormalEquations& sums, const Rigid& pose, const Prior* prior) {
  Matrix6 H;
  sums.full_matrix(H.data());
  H.diagonal().array() += kDamping * sums.weights;
  if (prior) return constrained_step(H, Vector6::Map(sums.g), prior->limits(pose));
  return -H.ldlt().solve(Vector6::Map(sums.g));
}

}  // namespace

LocalRefinementSettings coarse_refinement() {
  LocalRefinementSettings out;
  out.first_scale = 4;
  out.last_scale = 1;
  out.softness = 1e-2;
  out.step = 2e-2;
  out.iterations = 8;
  out.queries = 1500;
  out.first_queries = 500;
  out.both_ways = false;
  return out;
}

LocalRefinement::Side LocalRefinement::prepare(const Surface& surface, const Neighbors* near_other,
                                       const LocalRefinementSettings& settings) {
  const Cloud &p = surface.points, &n = surface.normals;
  require(n.size() == p.size(), "expected a normal for each point of a surface");
  require(surface.leaf > 0, "expected a surface with a leaf above 0");
  Side side;
  side.near = near_other;
  side.points.resize(p.size());
  std::vector<std::int32_t> usable;
  for (std::size_t i = 0; i < p.size(); ++i) {
    side.points[i] = {{p.x[i], p.y[i], p.z[i]}, {n.x[i], n.y[i], n.z[i]}};
    if (!std::isnan(n.x[i])) usable.push_back(static_cast<std::int32_t>(i));
  }
  const std::size_t all = std::min(settings.queries, usable.size()),
                    stride = std::max<std::size_t>(1, all / settings.first_queries);
  side.first = all ? (all - 1) / stride + 1 : 0;
  for (std::size_t phase = 0; phase < std::min(stride, all); ++phase)
    for (std::size_t k = phase; k < all; k += stride) {
      const std::int32_t i = usable[k * usable.size() / all];
      const float* place = side.points[static_cast<std::size_t>(i)].p;
      side.queries.push_back(i);
      side.places.x.push_back(place[0]);
      side.places.y.push_back(place[1]);
      side.places.z.push_back(place[2]);
    }
  return side;
}

LocalRefinement::LocalRefinement(const Surface& source, const Surface& target, const Neighbors* near_source,
                         const Neighbors* near_target, const LocalRefinementSettings& settings,
                         const Kernels& kernels)
    : settings_(checked(settings)),
      leaf_(target.leaf),
      source_(prepare(source, near_target, settings)),
      target_(prepare(target, near_source, settings)),
      kernels_(kernels) {
  require(near_target, "expected the neighbors of the target");
  require(near_source || !settings.both_ways, "expected the neighbors of the source");
}

/// visit(source, target) for the match of each of the queries begin to end of one side; their work
/// space starts at `place`.
template <class Visit>
void LocalRefinement::each_pair(const Look& at, bool reversed, std::size_t begin, std::size_t end,
                            std::size_t place, Scratch& s, const Visit& visit) const {
  const Side &asking = reversed ? target_ : source_, &answering = reversed ? source_ : target_;
  const Rigid way = reversed ? at.pose.inverse() : at.pose;
  const PointsView all = asking.places.view();
  const std::size_t n = end - begin;
  float *x = &s.x[place], *y = &s.y[place], *z = &s.z[place], *squared = &s.squared[place];
  std::int32_t* index = &s.index[place];
  transform(kernels_, {all.x + begin, all.y + begin, all.z + begin, n}, way, x, y, z);
  asking.near->nearest({x, y, z, n}, index, squared);

  const double reach = std::max(at.scale, settings_.reach * leaf_);
  const auto limit = static_cast<float>(reach * reach);
  for (std::size_t i = 0; i < n; ++i) {
    if (index[i] < 0 || !(squared[i] < limit)) continue;
    const Oriented& a = asking.points[static_cast<std::size_t>(asking.queries[begin + i])];
    const Oriented& b = answering.points[static_cast<std::size_t>(index[i])];
    visit(reversed ? b : a, reversed ? a : b);
  }
}

void LocalRefinement::look(const Look& at, Scratch& s, ThreadTeam& team, LocalRefinementResult& out) const {
  const std::size_t n = at.all ? source_.queries.size() : source_.first,
                    m = !settings_.both_ways ? 0
                        : at.all             ? target_.queries.size()
                                             : target_.first;
  const std::size_t blocks = (n + kBlock - 1) / kBlock, total = blocks + (m + kBlock - 1) / kBlock;
  s.blocks.assign(total, NormalEquations());
  const PlaneToPlane estimator(at.pose, at.scale, settings_.softness, settings_.normal_gate);
  const auto work = [&](std::size_t b) {
    const bool reversed = b >= blocks;
    const std::size_t begin = (reversed ? b - blocks : b) * kBlock;
    each_pair(at, reversed, begin, std::min(begin + kBlock, reversed ? m : n), b * kBlock, s,
              [&](const Oriented& source, const Oriented& target) {
                estimator.add(source, target, s.blocks[b]);
              });
  };
  team.parallel(total, [&](std::size_t b, std::size_t) { work(b); });
  const auto share = [](double inliers, std::size_t queries) {
    return queries ? inliers / static_cast<double>(queries) : 0;
  };
  NormalEquations sums;
  for (std::size_t b = 0; b < blocks; ++b) sums.add(s.blocks[b]);
  out.inlier_share_source = share(sums.inliers, n);
  const double own = sums.inliers;
  for (std::size_t b = blocks; b < total; ++b) sums.add(s.blocks[b]);
  out.inlier_share_target = share(sums.inliers - own, m);
  out.sums = sums;
  out.rmse = sums.weights > 0 ? std::sqrt(sums.squares / sums.weights) : 0;
}

LocalRefinementResult LocalRefinement::operator()(const Rigid& start, const Prior* prior, Scratch& s,
                                 int threads) const {
  LocalRefinementResult out;
  const auto body = [&](ThreadTeam& team) { out = refine_locally(start, prior, s, team); };
  ThreadTeam::with(threads, std::ref(body));
  return out;
}

LocalRefinementResult LocalRefinement::refine_locally(const Rigid& start, const Prior* prior, Scratch& s,
                               ThreadTeam& team) const {
  double T[16];
  to_matrix(start, T);
  require(is_rigid(T), "expected a finite rigid pose at the start");
  const std::size_t room =
      (source_.queries.size() / kBlock + target_.queries.size() / kBlock + 2) * kBlock;
  for (auto* v : {&s.x, &s.y, &s.z, &s.squared}) v->resize(std::max(v->size(), room));
  s.index.resize(std::max(s.index.size(), room));

  LocalRefinementResult out;
  out.both_ways = settings_.both_ways;
  const double last = settings_.last_scale * leaf_;
  Look at{start, settings_.first_scale * leaf_, settings_.first_scale <= settings_.last_scale};
  out.end = Termination::Iterations;
  while (out.iterations < settings_.iterations && out.end == Termination::Iterations) {
    look(at, s, team, out);
    ++out.iterations;
    const Vector6 step = solve(out.sums, at.pose, prior);
    if (out.sums.inliers < static_cast<double>(settings_.minimum_inliers) || !step.allFinite()) {
      out = {};
      at.pose = start;
      break;
    }
    at.pose = moved(at.pose, step.data());
    if (prior) at.pose = prior->project(at.pose);
    if (at.all && step.norm() < settings_.step * leaf_) out.end = Termination::Settled;
    at.scale = std::max(last, at.scale * settings_.shrink);
    at.all = at.all || at.scale <= last;
  }
  out.pose = at.pose;
  return out;
}

double LocalRefinement::design_effect(const LocalRefinementResult& refine_locally, Scratch& s) const {
  using Scores = std::array<double, 6>;
  const auto squared = [](const double* g) {
    double sum = 0;
    for (int k = 0; k < 6; ++k) sum += g[k] * g[k];
    return sum;
  };
  const Look at{refine_locally.pose, settings_.last_scale * leaf_, true};
  const PlaneToPlane estimator(at.pose, at.scale, settings_.softness, settings_.normal_gate);
  std::map<std::array<double, 3>, Scores> voxel_order;
  double of_pairs = 0, of_cubes = 0;
  const auto visit = [&](const Oriented& source, const Oriented& target) {
    NormalEquations one;
    estimator.add(source, target, one);
    std::array<double, 3> cube{};
    for (std::size_t a = 0; a < 3; ++a)
      cube[a] = std::floor(static_cast<double>(target.p[a]) / (kCluster * leaf_));
    Scores& sum = voxel_order[cube];
    for (std::size_t k = 0; k < 6; ++k) sum[k] += one.g[k];
    of_pairs += squared(one.g);
  };
  each_pair(at, false, 0, source_.queries.size(), 0, s, visit);
  if (settings_.both_ways) each_pair(at, true, 0, target_.queries.size(), 0, s, visit);
  for (const auto& [cube, sum] : voxel_order) of_cubes += squared(sum.data());
  return of_pairs > 0 ? std::max(1.0, of_cubes / of_pairs) : 1;
}

}  // namespace emtr
