#include "evolution/search_space.h"

#include <algorithm>
#include <cmath>

#include "geometry/euler.h"
#include "geometry/rotation_vector.h"
#include "util/constants.h"

namespace emtr {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

/// Returns a range cut to another one, or its nearest end where they do not meet.
Gene cut(double low, double high, double least, double most) {
  return {std::clamp(least, low, high), std::clamp(most, low, high), true};
}

}  // namespace

SearchSpace::SearchSpace(double translation_bound, const Prior* prior)
    : prior_(prior), rotation_genes_(emtr::rotation_genes()) {
  const std::vector<Gene> free = emtr::pose_genes(translation_bound);
  translation_genes_.assign(free.begin() + 3, free.end());
  if (!prior) return;
  const RotationLimits& limits = prior->rotation();
  if (limits.axis) {
    chart_ = Chart::Axis;
    const AxisLimits& axis = *limits.axis;
    angle_ = limits.angles().value_or(axis.angle);
    e1_ = axis.axis.unitOrthogonal();
    e2_ = axis.axis.cross(e1_);
    rotation_genes_ = {{angle_.middle - angle_.half, angle_.middle + angle_.half, !angle_.full()}};
    if (axis.tilt > 0) rotation_genes_.resize(3, {-axis.tilt, axis.tilt, true});
  } else if (!limits.balls.empty()) {
    chart_ = Chart::Vector;
    const auto smallest =
        std::min_element(limits.balls.begin(), limits.balls.end(),
                         [](const auto& a, const auto& b) { return a.radius < b.radius; });
    center_ = smallest->center;
    rotation_genes_.assign(3, {-smallest->radius, smallest->radius, true});
  }
  make_translation_genes(translation_bound);
}

void SearchSpace::make_translation_genes(double bound) {
  const TranslationLimits& limits = prior_->translation();
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    double low = -HUGE_VAL, high = HUGE_VAL;
    if (limits.ball) {
      low = limits.ball->center[i] - limits.ball->radius;
      high = limits.ball->center[i] + limits.ball->radius;
    }
    if (limits.box) {
      // R times the lever may point anywhere.
      const double reach = limits.box->lever.norm(), least = limits.box->low[i] - reach,
                   most = limits.box->high[i] + reach;
      const Gene narrow =
          cut(std::max(low, -bound), std::max(low, std::min(high, bound)), least, most);
      of_matrix_[k] = limits.box->high[i] - limits.box->low[i] < narrow.high - narrow.low;
      low = std::max(low, least);
      high = std::max(low, std::min(high, most));
    }
    translation_genes_[k] = of_matrix_[k] ? Gene{limits.box->low[i], limits.box->high[i], true}
                                          : cut(low, high, -bound, bound);
  }
}

std::vector<Gene> SearchSpace::pose_genes() const {
  std::vector<Gene> out = rotation_genes_;
  out.insert(out.end(), translation_genes_.begin(), translation_genes_.end());
  return out;
}

Quaterniond SearchSpace::rotated(const double* genes) const {
  if (chart_ == Chart::Vector) return exponential(Vector3d::Map(genes)) * center_;
  Quaterniond twist(Eigen::AngleAxisd(genes[0], prior_->rotation().axis->axis));
  if (angles() == 1) return twist;
  return exponential(genes[1] * e1_ + genes[2] * e2_) * twist;
}

Eigen::Matrix3d SearchSpace::rotation(const double* genes) const {
  if (!prior_) return euler_to_rotation(genes);
  Rigid pose;
  pose.R = chart_ == Chart::Euler ? euler_to_rotation(genes) : rotated(genes).toRotationMatrix();
  return prior_->project(pose).R;
}

Vector3d SearchSpace::lever_translation(const Eigen::Matrix3d& R) const {
  Vector3d out = Vector3d::Zero();
  for (int i = 0; i < 3; ++i)
    if (of_matrix_[i]) out[i] = Vector3d(R.row(i)).dot(prior_->translation().box->lever);
  return out;
}

Rigid SearchSpace::pose(const double* genes) const {
  if (!prior_) return decode(genes);
  Rigid out;
  out.R = rotation(genes);
  out.t = Vector3d::Map(genes + angles()) + lever_translation(out.R);
  return prior_->project(out);
}

void SearchSpace::encode(const Rigid& pose, double* genes) const {
  if (chart_ == Chart::Euler) {
    rotation_to_euler(pose.R, genes);
  } else if (chart_ == Chart::Vector) {
    Vector3d::Map(genes) = logarithm(Quaterniond(pose.R) * center_.conjugate());
  } else {
    const Vector3d& axis = prior_->rotation().axis->axis;
    const Quaterniond q = Quaterniond(pose.R);
    const SwingTwist about_axis(q, axis);
    genes[0] = angle_.middle + angle_.offset(about_axis.angle);
    if (angles() == 3) {
      const Vector3d tilt = logarithm(q * Eigen::AngleAxisd(-about_axis.angle, axis));
      genes[1] = tilt.dot(e1_);
      genes[2] = tilt.dot(e2_);
    }
  }
  encode_translation(pose, genes + angles());
}

void SearchSpace::encode_translation(const Rigid& pose, double* genes) const {
  Vector3d::Map(genes) = pose.t;
  if (prior_) Vector3d::Map(genes) -= lever_translation(pose.R);
}

void SearchSpace::arc(const double* from, const double* to, double share, double* out) const {
  const Quaterniond start(rotation(from)), end(rotation(to));
  Rigid pose;
  // Eigen's slerp takes the shorter of the two ways.
  pose.R = start.slerp(share, end).normalized().toRotationMatrix();
  double genes[6];
  encode(pose, genes);
  nearest_alias(genes, from, out);
}

void SearchSpace::nearest_alias(const double* genes, const double* reference, double* out) const {
  if (chart_ == Chart::Euler) return emtr::nearest_alias(genes, reference, out);
  std::copy_n(genes, angles(), out);
  if (chart_ == Chart::Axis && angle_.full())
    out[0] = genes[0] + 2 * kPi * std::round((reference[0] - genes[0]) / (2 * kPi));
}

}  // namespace emtr
