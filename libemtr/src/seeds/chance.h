#pragma once

#include <cstddef>
#include <vector>

#include "correspondences/match_points.h"
#include "geometry/rigid.h"

namespace emtr {

/// Tells how many sets of matches would agree on a pose by chance, if every match led anywhere: the
/// number of false alarms of Moisan and Stival, "A Probabilistic Criterion to Detect Rigid Point
/// Matches", IJCV 57 (2004). Wrong matches are taken to lead to the other matches' target points,
/// so neither the clouds' size nor their shape is assumed.
class Chance {
 public:
  /// The matches, three at least, must outlive it.
  explicit Chance(const MatchPoints& matches);

  /// Measures how near wrong matches come under a pose.
  void measure(const Rigid& pose);

  /// Returns the decimal logarithm of the expected number of sets of k >= 3 matches whose residuals
  /// are at most r under a common pose, when all matches are wrong.
  double log_expected(std::size_t k, double r) const;

  /// Returns the usual distance between the ends of two matches, on the side where it is less.
  double usual_length() const { return usual_length_; }

 private:
  /// The distribution of a positive number, from samples; where they are few, a power law goes on.
  class Distribution {
   public:
    /// `exponent`: of the power law, unless the samples are enough to tell a smaller or larger one,
    /// `most` at most.
    void set(std::vector<double> samples, double exponent, double most);
    double log_share_within(double x) const;

   private:
    std::vector<double> samples_;
    double smallest_ = 0, log_smallest_share_ = 0, exponent_ = 1;
  };

  const MatchPoints& matches_;
  const std::size_t n_;
  double usual_length_ = 0;
  std::vector<double> log_factorial_;
  Distribution differences_;  // of lengths that should be equal
  Distribution residuals_;
};

}  // namespace emtr
