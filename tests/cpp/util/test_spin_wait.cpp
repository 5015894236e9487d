#include <gtest/gtest.h>

#include "util/spin_wait.h"

namespace {

TEST(SpinWait, EndsAsSoonAsItIsDone) {
  int asked = 0;
  EXPECT_TRUE(emtr::spin_wait([&] { return ++asked == 3; }));
  EXPECT_EQ(asked, 3);
}

TEST(SpinWait, GivesUp) {
  EXPECT_FALSE(emtr::spin_wait([] { return false; }));
}

}  // namespace
