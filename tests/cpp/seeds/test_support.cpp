#include <gtest/gtest.h>

#include "seeds/support.h"
#include "support/clouds.h"

namespace {

/// As its definition says.
std::vector<std::size_t> oracle(const emtr::Consistency& c) {
  std::vector<std::size_t> out(c.size());
  for (std::size_t i = 0; i < c.size(); ++i)
    c.for_each_consistent(i, 0, [&](std::size_t j) { out[i] += c.common(i, j); });
  return out;
}

class SupportOf : public ::testing::TestWithParam<std::size_t> {};

TEST_P(SupportOf, EachIsWhatItsDefinitionSays) {
  const std::size_t n = GetParam();
  const emtr::Cloud p = emtr_test::uniform_cloud(n, 1), q = emtr_test::uniform_cloud(n, 2);
  std::vector<emtr::Correspondence> matches;
  for (std::size_t i = 0; i < n; ++i)
    matches.push_back({static_cast<std::int32_t>(i), static_cast<std::int32_t>(i)});
  for (const emtr::Kernels* kernels : emtr_test::kernels_here())
    for (const int threads : {1, 3}) {
      const emtr::Consistency c(p, q, matches, 0.3, *kernels, threads);
      std::vector<std::size_t> found;
      emtr::ThreadTeam::with(threads,
                             [&](emtr::ThreadTeam& team) { found = support_of_each(c, team); });
      EXPECT_EQ(found, oracle(c)) << kernels->name;
      if (n > 60) {
        EXPECT_GT(found[0], 10u);  // there is something to count
      }
    }
}

INSTANTIATE_TEST_SUITE_P(Sizes, SupportOf, ::testing::Values(1, 2, 63, 64, 65, 300));

}  // namespace
