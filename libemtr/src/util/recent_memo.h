#pragma once

#include <cstddef>

#include "util/memo.h"

namespace emtr {

/// A memo of which a process has few that hold something: those that were used last. The others
/// forget, however many objects are kept.
class RecentMemo {
 public:
  static constexpr std::size_t kMostFilled = 16;

  RecentMemo() = default;
  RecentMemo(const RecentMemo&) {}  ///< A copy knows nothing, as that of a Memo.
  RecentMemo& operator=(const RecentMemo&) = delete;
  ~RecentMemo();

  /// Returns the memo, from now on the last used of all.
  Memo& use();

 private:
  Memo memo_;
};

}  // namespace emtr
