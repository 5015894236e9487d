#pragma once

#include <sys/types.h>

#include <cstddef>
#include <functional>
#include <map>
#include <mutex>
#include <string>

#include "batch/pair.h"
#include "report/json.h"

namespace cli {

/// The file DIR/results.jsonl: a record is in it whole or not at all. The folder is made when it is
/// not there, and locked against other processes, by a POSIX record lock on DIR/results.lock, as
/// pyemtr does it.
class RecordFile {
 public:
  struct Counts {
    std::size_t registered = 0, not_registered = 0, errors = 0;
    std::size_t all() const { return registered + not_registered + errors; }
  };

  /// Cuts off a last line without its end, which a killed writer left. With `retry_errors` leaves
  /// out the records of pairs that failed. Throws FileFailure.
  RecordFile(const std::string& folder, bool retry_errors);
  ~RecordFile();
  RecordFile(const RecordFile&) = delete;
  RecordFile& operator=(const RecordFile&) = delete;

  bool has(std::size_t index) const { return places_.count(index) > 0; }
  /// Returns the record of one pair, which it must have.
  Json read(std::size_t index) const;
  /// Calls with each record, in the order of the pairs.
  void for_each(const std::function<void(const Json&)>& use) const;
  /// The largest index of a record; none: -1.
  std::ptrdiff_t last() const {
    return places_.empty() ? -1 : static_cast<std::ptrdiff_t>(places_.rbegin()->first);
  }
  Counts counts() const;

  /// Writes a record, and returns when the disk has it. Any number of threads may call it; records
  /// that come together are written in one call. Where it cannot write them whole, it writes none
  /// and throws FileFailure, now and ever after.
  void append(const Json& record);

  const std::string& folder() const { return folder_; }

 private:
  struct Place {
    off_t offset;
    std::size_t length;
  };
  void lock();
  void open_file();
  void read_all();
  void note(const Json& record, off_t offset, std::size_t length);
  void forget_errors();
  void write_pending();
  std::string text_at(const Place& place) const;

  const std::string folder_, path_;
  int lock_ = -1, file_ = -1;
  off_t end_ = 0;
  std::map<std::size_t, Place> places_;
  Counts counts_;
  std::string pending_;
  std::string broken_;  // why nothing can be written any more
  mutable std::mutex pending_mutex_, file_mutex_;
};

}  // namespace cli
