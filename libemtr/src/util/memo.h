#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <mutex>
#include <typeindex>
#include <utility>
#include <vector>

namespace emtr {

/// What was computed of one object that never changes. A value is known by its type, which one
/// function makes, and by the other arguments of that function.
///
/// Any number of threads may ask. None waits for another that computes what it asks for, since that
/// thread may be in its progress callback, which may come here again; both get the same bits.
class Memo {
 public:
  static constexpr std::size_t kKept = 24;  ///< values, those that were asked for last

  Memo() = default;
  Memo(const Memo&) {}  ///< A copy of the object may change before it is used.
  Memo& operator=(const Memo&) = delete;

  /// Returns the value, made by make() where it is not known. Keeps nothing where that throws.
  template <class Value, class Make>
  std::shared_ptr<const Value> get(const std::vector<double>& arguments, const Make& make) {
    const std::type_index type(typeid(Value));
    if (auto known = find(type, arguments)) return std::static_pointer_cast<const Value>(known);
    auto made = std::make_shared<const Value>(make());
    keep({type, arguments, made});
    return made;
  }

  void clear() {
    const std::lock_guard<std::mutex> lock(mutex_);
    entries_.clear();
  }

 private:
  struct Entry {
    std::type_index type;
    std::vector<double> arguments;
    std::shared_ptr<const void> value;
  };

  std::shared_ptr<const void> find(std::type_index type, const std::vector<double>& arguments) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) {
      return entry.type == type && entry.arguments == arguments;
    });
    if (found == entries_.end()) return nullptr;
    std::rotate(found, found + 1, entries_.end());
    return entries_.back().value;
  }

  void keep(Entry entry) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (entries_.size() == kKept) entries_.erase(entries_.begin());
    entries_.push_back(std::move(entry));
  }

  std::mutex mutex_;
  std::vector<Entry> entries_;  // the one that was asked for last at the end
};

}  // namespace emtr
