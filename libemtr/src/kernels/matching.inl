// Finds nearest neighbors among descriptors by comparing all with all. Included by each instruction
// set's file.

#include "kernels/lanes.h"

namespace emtr::EMTR_KERNEL {
namespace {

constexpr std::size_t kSide =
    std::size_t{2} * EMTR_REGISTER;  // columns at once; no sum goes across them
constexpr std::size_t kRows = 4;     // rows at once
constexpr std::size_t kTile =
    64 * kDescriptor;  // numbers a column that stay in the cache while the rows pass
using Columns = Floats<kSide>;

/// Enters a neighbor into a list before those that `is_before(their place)` says.
template <class IsBefore>
EMTR_INLINE void insert(const NearestLists& lists, std::size_t item, float squared,
                        std::int32_t index, const IsBefore& is_before) {
  std::size_t j = lists.k - 1;
  if (!is_before(j)) return;
  for (; j > 0 && is_before(j - 1); --j) {
    lists.squared[j * lists.stride + item] = lists.squared[(j - 1) * lists.stride + item];
    lists.index[j * lists.stride + item] = lists.index[(j - 1) * lists.stride + item];
  }
  lists.squared[j * lists.stride + item] = squared;
  lists.index[j * lists.stride + item] = index;
}

/// Enters a neighbor; of equal distances the one of the earlier call comes first.
inline void enter(const NearestLists& lists, std::size_t item, float squared, std::int32_t index) {
  insert(lists, item, squared, index,
         [&](std::size_t j) { return squared < lists.squared[j * lists.stride + item]; });
}

/// Enters the distances of one row to kSide columns.
EMTR_INLINE void enter_all(const Columns& squared, std::size_t row, std::int32_t first_row,
                           std::size_t first_column, const NearestLists& of_rows,
                           const NearestLists& of_columns) {
  const std::size_t row_last = (of_rows.k - 1) * of_rows.stride + row;
  const std::size_t column_last = (of_columns.k - 1) * of_columns.stride + first_column;
  const bool row_gains = any(squared < broadcast<kSide>(of_rows.squared[row_last]));
  const bool column_gains = any(squared < load<kSide>(of_columns.squared + column_last));
  if (!row_gains && !column_gains) return;
  float each[kSide];
  store<kSide, Floats>(each, squared);
  for (std::size_t l = 0; l < kSide; ++l) {
    if (row_gains) enter(of_rows, row, each[l], static_cast<std::int32_t>(first_column + l));
    if (column_gains)
      enter(of_columns, first_column + l, each[l], first_row + static_cast<std::int32_t>(row));
  }
}

/// Compares Number rows with kSide columns and sums over the descriptor in its order. Dimension is
/// a constant or, where it is not known beforehand, a number.
template <std::size_t Number, class Dimension>
EMTR_INLINE void compare(Dimension dimension, const float* rows, std::size_t row,
                         std::int32_t first_row, const float* columns, std::size_t first_column,
                         const NearestLists& of_rows, const NearestLists& of_columns) {
  const std::size_t size = dimension;
  Columns sum[Number] = {};
#pragma GCC unroll 1
  for (std::size_t d = 0; d < size; ++d) {
    const Columns column = load<kSide>(columns + d * kDescriptorBlock);
#pragma GCC unroll 4
    for (std::size_t r = 0; r < Number; ++r) {
      const Columns difference = broadcast<kSide>(rows[(row + r) * size + d]) - column;
      sum[r] = sum[r] + difference * difference;
    }
  }
  for (std::size_t r = 0; r < Number; ++r)
    enter_all(sum[r], row + r, first_row, first_column, of_rows, of_columns);
}

template <std::size_t Number, class Dimension>
EMTR_INLINE void compare_tile(Dimension dimension, const float* rows, std::size_t row,
                              std::int32_t first_row, const DescriptorBlocks& columns,
                              std::size_t begin, std::size_t end, const NearestLists& of_rows,
                              const NearestLists& of_columns) {
  for (std::size_t b = begin; b < end; ++b)
    for (std::size_t side = 0; side < kDescriptorBlock; side += kSide)
      compare<Number>(dimension, rows, row, first_row,
                      columns.values + b * dimension * kDescriptorBlock + side,
                      b * kDescriptorBlock + side, of_rows, of_columns);
}

template <class Dimension>
EMTR_INLINE void compare_all(Dimension dimension, const float* rows, std::size_t count,
                             std::int32_t first_row, const DescriptorBlocks& columns,
                             const NearestLists& of_rows, const NearestLists& of_columns) {
  const std::size_t tile = dimension < kTile ? kTile / dimension : 1;
  for (std::size_t begin = 0; begin < columns.blocks; begin += tile) {
    const std::size_t end = begin + tile < columns.blocks ? begin + tile : columns.blocks;
    std::size_t row = 0;
    for (; row + kRows <= count; row += kRows)
      compare_tile<kRows>(dimension, rows, row, first_row, columns, begin, end, of_rows,
                          of_columns);
    for (; row < count; ++row)
      compare_tile<1>(dimension, rows, row, first_row, columns, begin, end, of_rows, of_columns);
  }
}

struct Fpfh {
  constexpr operator std::size_t() const { return kDescriptor; }
};

void nearest_descriptors(const float* rows, std::size_t count, std::int32_t first_row,
                         const DescriptorBlocks& columns, const NearestLists& of_rows,
                         const NearestLists& of_columns) {
  if (columns.dimension == kDescriptor)
    compare_all(Fpfh{}, rows, count, first_row, columns, of_rows, of_columns);
  else
    compare_all(columns.dimension, rows, count, first_row, columns, of_rows, of_columns);
}

}  // namespace
}  // namespace emtr::EMTR_KERNEL
