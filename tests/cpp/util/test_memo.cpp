#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

#include "util/memo.h"

namespace {

struct Length {
  double value;
};
struct Area {
  double value;
};

TEST(Memo, MakesAValueOnceForEachTypeAndArguments) {
  emtr::Memo memo;
  int made = 0;
  const auto length = [&](double of) {
    return memo
        .get<Length>({of},
                     [&] {
                       ++made;
                       return Length{of};
                     })
        ->value;
  };
  EXPECT_EQ(length(3), 3);
  EXPECT_EQ(length(3), 3);
  EXPECT_EQ(made, 1);
  EXPECT_EQ(length(4), 4);
  EXPECT_EQ(made, 2);
  EXPECT_EQ(memo.get<Area>({3}, [] { return Area{9}; })->value, 9) << "another function's value";
}

TEST(Memo, KeepsThoseThatWereAskedForLast) {
  emtr::Memo memo;
  int made = 0;
  const auto ask = [&](std::size_t i) {
    memo.get<Length>({static_cast<double>(i)}, [&] {
      ++made;
      return Length{0};
    });
  };
  for (std::size_t i = 0; i < emtr::Memo::kKept; ++i) ask(i);
  ask(0);
  ask(emtr::Memo::kKept);  // in the place of 1
  made = 0;
  ask(0);
  EXPECT_EQ(made, 0);
  ask(1);
  EXPECT_EQ(made, 1);
}

TEST(Memo, KeepsNothingOfAFunctionThatThrows) {
  emtr::Memo memo;
  const auto fails = []() -> Length { throw std::runtime_error("no length"); };
  EXPECT_THROW(memo.get<Length>({}, fails), std::runtime_error);
  EXPECT_EQ(memo.get<Length>({}, [] { return Length{5}; })->value, 5);
}

TEST(Memo, ACopyKnowsNothing) {
  emtr::Memo memo;
  memo.get<Length>({}, [] { return Length{1}; });
  emtr::Memo copy = memo;
  EXPECT_EQ(copy.get<Length>({}, [] { return Length{2}; })->value, 2);
}

TEST(Memo, AValueOutlivesItsPlace) {
  emtr::Memo memo;
  const auto first = memo.get<Length>({-1}, [] { return Length{7}; });
  for (std::size_t i = 0; i <= emtr::Memo::kKept; ++i)
    memo.get<Length>({static_cast<double>(i)}, [] { return Length{0}; });
  EXPECT_EQ(first->value, 7);
}

}  // namespace
