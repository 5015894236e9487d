#pragma once

#include <cstddef>
#include <functional>
#include <future>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <unordered_map>

#include "batch/read_cloud.h"

namespace cli {

using ReadCloudPtr = std::shared_ptr<const ReadCloud>;

/// Clouds that are each read once, kept within a limit of memory. Any number of threads may ask:
/// those that want a cloud which another thread reads wait for it. Beyond the limit, the clouds
/// that were not asked for the longest are dropped; whoever works with one still has it.
class CloudCache {
 public:
  explicit CloudCache(std::size_t limit_bytes) : limit_(limit_bytes) {}

  /// Returns the cloud of that key, by `read` if it is not there. An exception of `read` reaches
  /// all who wait for the cloud, and is forgotten then.
  ReadCloudPtr get(const std::string& key, const std::function<ReadCloudPtr()>& read);

 private:
  struct Entry {
    std::shared_future<ReadCloudPtr> cloud;
    std::size_t bytes = 0;  // 0 until it is read
    std::list<std::string>::iterator use;
  };
  ReadCloudPtr read_now(const std::string& key, std::promise<ReadCloudPtr>& promise,
                        const std::function<ReadCloudPtr()>& read);
  void drop_beyond_limit();

  const std::size_t limit_;
  std::mutex mutex_;
  std::unordered_map<std::string, Entry> entries_;
  std::list<std::string> uses_;  // keys, the latest use first
  std::size_t bytes_ = 0;
};

}  // namespace cli
