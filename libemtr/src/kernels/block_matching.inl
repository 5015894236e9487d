// Finds nearest neighbors among descriptors without comparing all with all: pairs are left out
// whose principal coordinates alone are too far apart. Included by each instruction set's file,
// after matching.inl.

#include "kernels/lanes.h"

namespace emtr::EMTR_KERNEL {
namespace {

constexpr std::size_t kFewCoordinates = kPrincipal / 2;  // tell most pairs apart

/// Enters a neighbor; of equal distances the smaller index comes first, whatever the order of
/// calls.
inline void enter_in_order(const NearestLists& lists, std::size_t item, float squared,
                           std::int32_t index) {
  insert(lists, item, squared, index, [&](std::size_t j) {
    const float other = lists.squared[j * lists.stride + item];
    return squared < other || (squared == other && index < lists.index[j * lists.stride + item]);
  });
}

EMTR_INLINE const float* last_of(const NearestLists& lists, std::size_t item) {
  return lists.squared + (lists.k - 1) * lists.stride + item;
}

/// Adds the squared differences of some coordinates of one row and kSide columns.
EMTR_INLINE Columns add_coordinates(const Columns& before, const PrincipalBlock& rows,
                                    std::size_t row, const float* columns, std::size_t first,
                                    std::size_t last) {
  Columns sum = before;
#pragma GCC unroll 8
  for (std::size_t d = first; d < last; ++d) {
    const Columns difference = broadcast<kSide>(rows.principal[d * kDescriptorBlock + row]) -
                               load<kSide>(columns + d * kDescriptorBlock);
    sum = sum + difference * difference;
  }
  return sum;
}

/// Writes the lower bounds of the squared distances of the rows to the box of the columns.
EMTR_INLINE void distances_to_box(const PrincipalBlock& rows, const PrincipalBlock& columns,
                                  float* out) {
  for (std::size_t side = 0; side < kDescriptorBlock; side += kSide) {
    Columns sum = {};
#pragma GCC unroll 8
    for (std::size_t d = 0; d < kFewCoordinates; ++d) {
      const Columns x = load<kSide>(rows.principal + d * kDescriptorBlock + side);
      const Columns gap = maximum(
          maximum(broadcast<kSide>(columns.low[d]) - x, x - broadcast<kSide>(columns.high[d])),
          broadcast<kSide>(0.0f));
      sum = sum + gap * gap;
    }
    store<kSide, Floats>(out + side, sum);
  }
}

/// Enters the distances of one row to kSide columns, summed over the descriptor in its order.
EMTR_INLINE void enter_distances(const PrincipalBlock& rows, std::size_t row,
                                 const PrincipalBlock& columns, std::size_t side,
                                 std::size_t dimension, const NearestLists& of_rows,
                                 const NearestLists& of_columns) {
  Columns sum = {};
#pragma GCC unroll 1
  for (std::size_t d = 0; d < dimension; ++d) {
    const Columns difference = broadcast<kSide>(rows.values[d * kDescriptorBlock + row]) -
                               load<kSide>(columns.values + d * kDescriptorBlock + side);
    sum = sum + difference * difference;
  }
  // Most are beyond the last of both lists.
  const std::size_t item = rows.first + row, first = columns.first + side;
  const std::uint32_t of_row = bits_of(broadcast<kSide>(*last_of(of_rows, item)) >= sum),
                      of_column = bits_of(load<kSide>(last_of(of_columns, first)) >= sum);
  if ((of_row | of_column) == 0) return;
  float each[kSide];
  store<kSide, Floats>(each, sum);
  for (std::uint32_t left = of_row; left != 0; left &= left - 1) {
    const auto l = static_cast<std::size_t>(__builtin_ctz(left));
    enter_in_order(of_rows, item, each[l], columns.index[side + l]);
  }
  for (std::uint32_t left = of_column; left != 0; left &= left - 1) {
    const auto l = static_cast<std::size_t>(__builtin_ctz(left));
    enter_in_order(of_columns, first + l, each[l], rows.index[row]);
  }
}

void nearest_in_blocks(const PrincipalBlock& rows, const PrincipalBlock& columns,
                       std::size_t dimension, const DistanceBound& bound, const float* known,
                       const NearestLists& of_rows, const NearestLists& of_columns) {
  float largest = 0;  // distance that a column of the block has use for
  for (std::size_t c = 0; c < kDescriptorBlock && columns.index[c] >= 0; ++c) {
    const float own = *last_of(of_columns, columns.first + c);
    const float least = known[columns.first + c] < own ? known[columns.first + c] : own;
    largest = largest < least ? least : largest;
  }
  float to_box[kDescriptorBlock];
  distances_to_box(rows, columns, to_box);
  for (std::size_t row = 0; row < kDescriptorBlock && rows.index[row] >= 0; ++row) {
    const float* last = last_of(of_rows, rows.first + row);
    if (to_box[row] > (*last < largest ? largest : *last) * bound.factor + bound.slack) continue;
    for (std::size_t side = 0; side < kDescriptorBlock; side += kSide) {
      const std::size_t first = columns.first + side;
      const Columns of_column =
          minimum(load<kSide>(last_of(of_columns, first)), load<kSide>(known + first));
      const Columns limit =
          maximum(of_column, broadcast<kSide>(*last)) * broadcast<kSide>(bound.factor) +
          broadcast<kSide>(bound.slack);
      const Columns few =
          add_coordinates(Columns{}, rows, row, columns.principal + side, 0, kFewCoordinates);
      if (!any(few < limit)) continue;
      const Columns all =
          add_coordinates(few, rows, row, columns.principal + side, kFewCoordinates, kPrincipal);
      if (any(all < limit))
        enter_distances(rows, row, columns, side, dimension, of_rows, of_columns);
    }
  }
}

}  // namespace
}  // namespace emtr::EMTR_KERNEL
