#include "batch/cloud_cache.h"

#include <exception>

namespace cli {

ReadCloudPtr CloudCache::get(const std::string& key, const std::function<ReadCloudPtr()>& read) {
  std::promise<ReadCloudPtr> promise;
  std::shared_future<ReadCloudPtr> cloud;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = entries_.find(key);
    if (found != entries_.end()) {
      uses_.splice(uses_.begin(), uses_, found->second.use);
      cloud = found->second.cloud;
    } else {
      uses_.push_front(key);
      entries_[key] = {promise.get_future().share(), 0, uses_.begin()};
    }
  }
  return cloud.valid() ? cloud.get() : read_now(key, promise, read);
}

ReadCloudPtr CloudCache::read_now(const std::string& key, std::promise<ReadCloudPtr>& promise,
                                  const std::function<ReadCloudPtr()>& read) {
  try {
    ReadCloudPtr made = read();
    const std::lock_guard<std::mutex> lock(mutex_);
    entries_[key].bytes = made->bytes;
    bytes_ += made->bytes;
    promise.set_value(made);
    drop_beyond_limit();
    return made;
  } catch (...) {
    promise.set_exception(std::current_exception());
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = entries_.find(key);
    uses_.erase(found->second.use);
    entries_.erase(found);
    throw;
  }
}

void CloudCache::drop_beyond_limit() {
  for (auto use = uses_.end(); bytes_ > limit_ && use != uses_.begin();) {
    const auto entry = entries_.find(*--use);
    if (entry->second.bytes == 0) continue;  // somebody reads it now
    bytes_ -= entry->second.bytes;
    entries_.erase(entry);
    use = uses_.erase(use);
  }
}

}  // namespace cli
