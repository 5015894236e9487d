#include "util/recent_memo.h"

#include <list>
#include <mutex>

namespace emtr {
namespace {

struct Filled {
  std::mutex mutex;
  std::list<Memo*> memos;  // the last used at the end
};

/// Is never destroyed: a cloud that is static may outlive all other static objects.
Filled& filled() {
  static auto* const all = new Filled;
  return *all;
}

}  // namespace

RecentMemo::~RecentMemo() {
  Filled& all = filled();
  const std::lock_guard<std::mutex> lock(all.mutex);
  all.memos.remove(&memo_);
}

Memo& RecentMemo::use() {
  Filled& all = filled();
  const std::lock_guard<std::mutex> lock(all.mutex);
  all.memos.remove(&memo_);
  all.memos.push_back(&memo_);
  if (all.memos.size() > kMostFilled) {
    all.memos.front()->clear();
    all.memos.pop_front();
  }
  return memo_;
}

}  // namespace emtr
