#include <gtest/gtest.h>

#include <cstring>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "pipeline/result_table.h"
#include "util/stage.h"

namespace {

std::size_t size_of(emtr_field_type type) {
  switch (type) {
    case EMTR_FIELD_REAL:
      return sizeof(double);
    case EMTR_FIELD_INT32:
    case EMTR_FIELD_SWITCH:
      return sizeof(std::int32_t);
    case EMTR_FIELD_SIZE:
      return sizeof(std::size_t);
    case EMTR_FIELD_UINT64:
      return sizeof(std::uint64_t);
    case EMTR_FIELD_TEXT:
      return sizeof(const char*);
    case EMTR_FIELD_REASON:
      return sizeof(emtr_reason);
    case EMTR_FIELD_ALTERNATIVE:
      return sizeof(emtr_alternative);
  }
  ADD_FAILURE() << "type " << type;
  return 0;
}

std::size_t bytes_of(const emtr_result_field_info& row) {
  return row.columns ? size_of(row.type) * row.rows * row.columns : sizeof(void*);
}

TEST(ResultTable, CoversEveryByteOfAResultOnce) {
  std::vector<int> covered(sizeof(emtr_result));
  const auto cover = [&](std::size_t offset, std::size_t bytes) {
    for (std::size_t i = offset; i < offset + bytes; ++i) ++covered.at(i);
  };
  cover(offsetof(emtr_result, size), sizeof(std::size_t));
  cover(offsetof(emtr_result, alternative_count), sizeof(std::size_t));
  for (const auto& row : emtr::result_table()) cover(row.offset, bytes_of(row));
  for (std::size_t i = 0; i < covered.size();) {
    EXPECT_LE(covered[i], 1) << "byte " << i << " is in two rows";
    // Between fields there is at most the padding in front of a field of eight bytes.
    std::size_t gap = 0;
    while (i + gap < covered.size() && !covered[i + gap]) ++gap;
    EXPECT_LE(gap, 4u) << "bytes from " << i << " are in no row";
    if (gap) {
      EXPECT_EQ((i + gap) % 8, 0u) << "bytes from " << i << " are in no row";
    }
    i += gap ? gap : 1;
  }
}

/// Initializes a field of any type, or one element of an array.
struct Anything {
  template <class T>
  operator T() const;
};
template <std::size_t>
using One = Anything;

template <class Struct, std::size_t... I>
auto takes(std::index_sequence<I...>) -> decltype(Struct{One<I>{}...}, std::true_type());
template <class Struct>
std::false_type takes(...);

/// Returns how many values an aggregate is made of, those of its arrays one by one.
template <class Struct, std::size_t N = 1>
constexpr std::size_t values_of() {
  if constexpr (decltype(takes<Struct>(std::make_index_sequence<N + 1>()))::value)
    return values_of<Struct, N + 1>();
  else
    return N;
}

// A small field in the padding between two others would leave no byte uncovered.
TEST(ResultTable, HasAsManyValuesAsAResult) {
  std::size_t values = 2;  // size and alternative_count
  for (const auto& row : emtr::result_table()) values += row.columns ? row.rows * row.columns : 1;
  EXPECT_EQ(values, (values_of<emtr_result>()));
}

TEST(ResultTable, PointersKnowTheirLength) {
  for (const auto& row : emtr::result_table()) {
    EXPECT_EQ(row.columns == 0, row.count_offset != 0) << row.name;
    if (row.count_offset) {
      EXPECT_EQ(row.count_offset, row.type == EMTR_FIELD_ALTERNATIVE
                                      ? offsetof(emtr_result, alternative_count)
                                      : offsetof(emtr_result, iterations));
    }
  }
}

TEST(ResultTable, NamesAndKeysAreUnique) {
  std::set<std::string> names, keys;
  for (const auto& row : emtr::result_table()) {
    EXPECT_TRUE(names.insert(row.name).second) << row.name;
    EXPECT_TRUE(keys.insert(std::string(row.group) + '/' + row.key).second) << row.key;
    EXPECT_STRNE(row.text, "") << row.name;
    const std::string name = row.name, key = row.key;
    EXPECT_TRUE(name == key || name == std::string(row.group) + '_' + key) << name;
  }
}

TEST(ResultTable, SecondsAreThoseOfTheStagesAndTheTotal) {
  std::vector<std::string> keys, stages;
  for (const auto& row : emtr::result_table())
    if (std::strcmp(row.group, "seconds") == 0) keys.emplace_back(row.key);
  for (std::size_t i = 0; i < emtr::kStageCount; ++i)
    stages.emplace_back(emtr::stage_name(static_cast<emtr::Stage>(i)));
  stages.emplace_back("total");
  EXPECT_EQ(keys, stages);
}

TEST(ResultTable, IsPublishedInC) {
  ASSERT_EQ(emtr_result_field_count(), emtr::result_table().size());
  emtr_result_field_info info;
  for (std::size_t i = 0; i < emtr_result_field_count(); ++i) {
    ASSERT_EQ(emtr_result_field_describe(i, &info, sizeof info), EMTR_OK);
    EXPECT_STREQ(info.name, emtr::result_table()[i].name);
    EXPECT_EQ(info.offset, emtr::result_table()[i].offset);
  }
  EXPECT_EQ(emtr_result_field_describe(emtr_result_field_count(), &info, sizeof info),
            EMTR_ERROR_ARGUMENT);
  EXPECT_EQ(emtr_result_field_describe(0, &info, 8), EMTR_ERROR_ARGUMENT);
  EXPECT_EQ(emtr_result_field_describe(0, nullptr, sizeof info), EMTR_ERROR_ARGUMENT);
}

TEST(Stage, NamesArePublishedInC) {
  for (std::size_t i = 0; i < emtr::kStageCount; ++i)
    EXPECT_STREQ(emtr_stage_name(i), emtr::stage_name(static_cast<emtr::Stage>(i)));
  EXPECT_STREQ(emtr_stage_name(0), "normalization");
  EXPECT_STREQ(emtr_stage_name(8), "fallback_search");
  EXPECT_EQ(emtr_stage_name(emtr::kStageCount), nullptr);
}

}  // namespace
