#pragma once

#include <pcl/correspondence.h>
#include <pcl/point_cloud.h>
#include <pcl/point_representation.h>
#include <pcl/point_types.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace pcl {
namespace detail {

/** \brief Holds user-provided numbers, one row for each point, or none. */
struct UserRows {
  std::vector<float> values;
  std::size_t rows = 0;
  std::size_t width = 0;  ///< numbers in a row
  bool given = false;

  /** \brief Returns the rows of \a indices, in their order. */
  template <typename Index>
  UserRows select(const std::vector<Index>& indices) const {
    UserRows out;
    out.given = given;
    out.width = width;
    out.rows = indices.size();
    out.values.reserve(out.rows * width);
    for (const Index index : indices) {
      const float* row = values.data() + static_cast<std::size_t>(index) * width;
      out.values.insert(out.values.end(), row, row + width);
    }
    return out;
  }
};

/** \brief Holds user-provided normals and features of one cloud's points. */
struct UserInput {
  UserRows normals, features;

  bool empty() const { return !normals.given && !features.given; }

  /** \brief Describes why they do not fit a cloud of \a points; empty if they do. */
  std::string mismatch(const std::string& name, std::size_t points) const {
    const auto check = [&](const UserRows& input, const std::string& what) {
      if (!input.given || input.rows == points) return std::string();
      return name + " cloud: " + std::to_string(input.rows) + " " + what +
             ", expected one for each of its " + std::to_string(points) + " points";
    };
    const std::string normal = check(normals, "normals");
    return normal.empty() ? check(features, "features") : normal;
  }

  /** \brief Returns the rows of \a indices, in their order. */
  template <typename Index>
  UserInput select(const std::vector<Index>& indices) const {
    UserInput out;
    if (normals.given) out.normals = normals.select(indices);
    if (features.given) out.features = features.select(indices);
    return out;
  }
};

/** \brief Packs the components of all normals. */
inline UserRows packNormals(const PointCloud<Normal>& cloud) {
  UserRows out;
  out.given = true;
  out.rows = cloud.size();
  out.width = 3;
  for (const Normal& normal : cloud)
    out.values.insert(out.values.end(), {normal.normal_x, normal.normal_y, normal.normal_z});
  return out;
}

/** \brief Packs the vectors of all descriptors; a descriptor that the representation calls invalid
 * becomes NaN. */
template <typename FeatureT>
UserRows packFeatures(const PointCloud<FeatureT>& cloud,
                      const PointRepresentation<FeatureT>& representation) {
  UserRows out;
  out.given = true;
  out.rows = cloud.size();
  out.width = static_cast<std::size_t>(representation.getNumberOfDimensions());
  out.values.assign(out.rows * out.width, std::numeric_limits<float>::quiet_NaN());
  for (std::size_t i = 0; i < out.rows; ++i) {
    float* row = out.values.data() + i * out.width;
    if (representation.isValid(cloud[i])) representation.vectorize(cloud[i], row);
  }
  return out;
}

/** \brief Makes PCL's representation of a descriptor. */
template <typename FeatureT>
struct DefaultFeature {
  static DefaultPointRepresentation<FeatureT> make() { return {}; }

  /** \brief Checks whether PCL knows the type: of an unknown one it takes the first three numbers.
   */
  static bool known() {
    const auto numbers = static_cast<std::size_t>(make().getNumberOfDimensions());
    return numbers > 3 || sizeof(FeatureT) == sizeof(float) * numbers;
  }
};

/** \brief Represents a Histogram by all its numbers; PCL would take the first three. */
template <int N>
struct DefaultFeature<Histogram<N>> {
  static CustomPointRepresentation<Histogram<N>> make() { return {N}; }
  static bool known() { return true; }
};

/** \brief Converts an index to a row number of the library; -1, which the library reports, if it
 * does not fit. */
template <typename Index>
std::int32_t rowNumber(Index index) {
  const auto number = static_cast<std::int64_t>(index);
  const bool fits = number >= 0 && number <= std::numeric_limits<std::int32_t>::max();
  return fits ? static_cast<std::int32_t>(number) : -1;
}

/** \brief Renumbers the source points of correspondences by their places in \a indices, which
 * select from a cloud of \a points. Leaves out correspondences of points that are not selected. */
template <typename Index>
std::vector<std::int32_t> renumber(const std::vector<std::int32_t>& pairs,
                                   const std::vector<Index>& indices, std::size_t points) {
  constexpr std::int32_t kUnselected = -1;
  std::vector<std::int32_t> place(points, kUnselected), out;
  for (std::size_t i = indices.size(); i-- > 0;)
    place[static_cast<std::size_t>(indices[i])] = static_cast<std::int32_t>(i);
  for (std::size_t i = 0; i < pairs.size(); i += 2) {
    const auto row = static_cast<std::size_t>(pairs[i]);
    if (place[row] != kUnselected) out.insert(out.end(), {place[row], pairs[i + 1]});
  }
  return out;
}

}  // namespace detail
}  // namespace pcl
