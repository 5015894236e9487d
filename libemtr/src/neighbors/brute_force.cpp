#include <vector>

#include "neighbors/neighbors.h"

namespace emtr {
namespace {

/// Compares all with all: the oracle of the other structures.
class BruteForce final : public Neighbors {
 public:
  BruteForce(const Cloud& cloud, float radius) : cloud_(cloud), limit_(radius * radius) {}

  void squared_distances(const PointsView& queries, float* out) const override {
    std::vector<std::int32_t> index(queries.size);
    nearest(queries, index.data(), out);
  }

  void nearest(const PointsView& q, std::int32_t* index, float* squared) const override {
    for (std::size_t i = 0; i < q.size; ++i) {
      squared[i] = limit_;
      index[i] = -1;
      for (std::size_t k = 0; k < cloud_.size(); ++k) {
        const float d =
            squared_distance(q.x[i] - cloud_.x[k], q.y[i] - cloud_.y[k], q.z[i] - cloud_.z[k]);
        if (d < squared[i]) {
          squared[i] = d;
          index[i] = static_cast<std::int32_t>(k);
        }
      }
    }
  }

 private:
  Cloud cloud_;
  float limit_;
};

}  // namespace

std::unique_ptr<Neighbors> make_brute_force(const Cloud& cloud, float radius) {
  return std::make_unique<BruteForce>(cloud, radius);
}

}  // namespace emtr
