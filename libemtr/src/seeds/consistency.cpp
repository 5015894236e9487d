#include "seeds/consistency.h"

#include "kernels/search_kernels.h"
#include "util/thread_team.h"

namespace emtr {
namespace {

Cloud matched_points(const Cloud& cloud, const std::vector<Correspondence>& correspondences,
                     std::int32_t Correspondence::*side, std::size_t padded_size) {
  Cloud out = cloud.select(rows_of(correspondences, side));
  out.resize(padded_size);
  return out;
}

}  // namespace

Consistency::Consistency(const Cloud& source, const Cloud& target,
                         const std::vector<Correspondence>& correspondences, double threshold,
                         const Kernels& kernels, int threads)
    : kernels_(kernels), n_(correspondences.size()), words_((n_ + 63) / 64) {
  p_ = matched_points(source, correspondences, &Correspondence::source, 64 * words_);
  q_ = matched_points(target, correspondences, &Correspondence::target, 64 * words_);
  bits_.resize(n_ * words_);
  degree_.resize(n_);
  PointsView p = p_.view(), q = q_.view();
  p.size = q.size = n_;
  ThreadTeam::with(threads, [&](ThreadTeam& team) {
    team.parallel(n_, [&](std::size_t i, std::size_t) {
      std::uint64_t* bits = &bits_[i * words_];
      kernels_.consistent(p, q, i, static_cast<float>(threshold), bits);
      bits[i / 64] &= ~(std::uint64_t{1} << (i % 64));  // not with itself
      if (n_ % 64) bits[words_ - 1] &= (std::uint64_t{1} << (n_ % 64)) - 1;
      degree_[i] = kernels_.count_common(bits, bits, words_);
    });
  });
}

std::size_t Consistency::inliers(const Rigid& pose, double squared_distance,
                                 std::uint64_t* bits) const {
  double matrix[16];
  to_matrix(pose, matrix);
  PointsView p = p_.view(), q = q_.view();
  p.size = q.size = n_;
  return search_kernels(kernels_).pose_inliers(p, q, matrix, squared_distance, bits);
}

}  // namespace emtr
