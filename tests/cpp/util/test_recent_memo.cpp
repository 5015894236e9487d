#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "util/recent_memo.h"

namespace {

struct Length {
  double value;
};

bool knows(emtr::RecentMemo& memo) {
  bool made = false;
  memo.use().get<Length>({}, [&] {
    made = true;
    return Length{1};
  });
  return !made;
}

TEST(RecentMemo, ForgetsOnceEnoughOthersWereUsed) {
  emtr::RecentMemo memo;
  std::vector<std::unique_ptr<emtr::RecentMemo>> others;
  for (std::size_t i = 0; i < emtr::RecentMemo::kMostFilled; ++i)
    others.push_back(std::make_unique<emtr::RecentMemo>());
  knows(memo);
  for (std::size_t i = 0; i + 1 < others.size(); ++i) knows(*others[i]);
  EXPECT_TRUE(knows(memo));  // and is now the last used
  knows(*others.back());
  EXPECT_TRUE(knows(memo));
  EXPECT_FALSE(knows(*others.front()));
}

TEST(RecentMemo, OneThatIsGoneTakesNoPlace) {
  emtr::RecentMemo memo;
  knows(memo);
  for (std::size_t i = 0; i < 3 * emtr::RecentMemo::kMostFilled; ++i) {
    emtr::RecentMemo gone;
    knows(gone);
  }
  EXPECT_TRUE(knows(memo));
}

TEST(RecentMemo, ACopyKnowsNothing) {
  emtr::RecentMemo memo;
  knows(memo);
  emtr::RecentMemo copy = memo;
  EXPECT_FALSE(knows(copy));
  EXPECT_TRUE(knows(memo));
}

}  // namespace
