#include "batch/record_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

#include "batch/record.h"
#include "failure.h"
#include "write/output_files.h"

namespace cli {
namespace {

[[noreturn]] void fail(const std::string& path, const std::string& what) {
  throw FileFailure(path, what + ": " + std::strerror(errno));
}

void sync_folder(const std::string& folder) {
  const int file = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (file < 0 || fsync(file) != 0) fail(folder, "cannot be written");
  close(file);
}

}  // namespace

RecordFile::RecordFile(const std::string& folder, bool retry_errors)
    : folder_(folder), path_((std::filesystem::path(folder) / "results.jsonl").string()) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error && !std::filesystem::is_directory(folder))
    throw FileFailure(folder, "cannot be made: " + error.message());
  try {
    lock();
    open_file();
    read_all();
    if (retry_errors && counts_.errors > 0) forget_errors();
  } catch (...) {
    if (file_ >= 0) close(file_);
    if (lock_ >= 0) close(lock_);
    throw;
  }
}

RecordFile::~RecordFile() {
  close(file_);
  close(lock_);
}

void RecordFile::lock() {
  const std::string path = (std::filesystem::path(folder_) / "results.lock").string();
  lock_ = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (lock_ < 0) fail(path, "cannot be written");
  struct flock whole {};
  whole.l_type = F_WRLCK;
  whole.l_whence = SEEK_SET;
  if (fcntl(lock_, F_SETLK, &whole) == 0) return;
  if (errno != EACCES && errno != EAGAIN) fail(path, "cannot be locked");
  throw FileFailure(folder_, "another run writes to this folder; wait for it, or name another");
}

void RecordFile::open_file() {
  file_ = open(path_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (file_ < 0) fail(path_, "cannot be written");
  sync_folder(folder_);
  struct stat status;
  if (fstat(file_, &status) != 0) fail(path_, "cannot be read");
  end_ = status.st_size;
}

std::string RecordFile::text_at(const Place& place) const {
  std::string text(place.length, '\0');
  std::size_t done = 0;
  while (done < text.size()) {
    const ssize_t got =
        pread(file_, &text[done], text.size() - done, place.offset + static_cast<off_t>(done));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) fail(path_, "cannot be read");
    done += static_cast<std::size_t>(got);
  }
  return text;
}

void RecordFile::read_all() {
  places_.clear();
  counts_ = {};
  constexpr std::size_t step = 1 << 20;
  std::string rest;  // of a line that goes on in the next step
  off_t begin = 0;   // of that line
  std::size_t number = 0;
  for (off_t at = 0; at < end_;) {
    const auto size = std::min(step, static_cast<std::size_t>(end_ - at));
    rest += text_at({at, size});
    at += static_cast<off_t>(size);
    std::size_t from = 0;
    for (std::size_t to; (to = rest.find('\n', from)) != std::string::npos; from = to + 1) {
      ++number;
      const std::size_t length = to + 1 - from;
      try {
        note(Json::parse(rest.begin() + static_cast<std::ptrdiff_t>(from),
                         rest.begin() + static_cast<std::ptrdiff_t>(to)),
             begin, length);
      } catch (const Json::exception& error) {
        throw FileFailure(path_, "line " + std::to_string(number) +
                                     ": expected the record of a pair: " + error.what());
      }
      begin += static_cast<off_t>(length);
    }
    rest.erase(0, from);
  }
  if (begin == end_) return;
  if (ftruncate(file_, begin) != 0 || fsync(file_) != 0) fail(path_, "cannot be mended");
  end_ = begin;
}

void RecordFile::note(const Json& record, off_t offset, std::size_t length) {
  const auto index = record.at("index").get<std::size_t>();
  if (!places_.insert({index, {offset, length}}).second)
    throw FileFailure(path_, "has two records of pair " + std::to_string(index));
  const auto status = record.at("status").get<std::string>();
  ++(status == "registered"       ? counts_.registered
     : status == "not_registered" ? counts_.not_registered
                                  : counts_.errors);
}

void RecordFile::forget_errors() {
  std::string kept;
  for (const auto& [index, place] : places_) {
    const std::string text = text_at(place);
    if (Json::parse(text).at("status") != "error") kept += text;
  }
  OutputFiles files;
  files.write_text(path_, kept);
  files.commit();
  close(file_);
  open_file();
  if (fsync(file_) != 0) fail(path_, "cannot be written");
  read_all();
}

Json RecordFile::read(std::size_t index) const { return Json::parse(text_at(places_.at(index))); }

void RecordFile::for_each(const std::function<void(const Json&)>& use) const {
  for (const auto& place : places_) use(Json::parse(text_at(place.second)));
}

RecordFile::Counts RecordFile::counts() const {
  const std::lock_guard<std::mutex> lock(file_mutex_);
  return counts_;
}

void RecordFile::append(const Json& record) {
  {
    const std::lock_guard<std::mutex> lock(pending_mutex_);
    pending_ += record_line(record);
  }
  const std::lock_guard<std::mutex> lock(file_mutex_);
  write_pending();
}

void RecordFile::write_pending() {
  std::string text;
  {
    const std::lock_guard<std::mutex> lock(pending_mutex_);
    text.swap(pending_);
  }
  if (!broken_.empty()) throw FileFailure(path_, broken_);
  if (text.empty()) return;  // another thread wrote it with its own
  const ssize_t written = write(file_, text.data(), text.size());
  if (written != static_cast<ssize_t>(text.size()) || fsync(file_) != 0) {
    broken_ = written >= 0 ? "cannot be written whole, is the disk full?"
                           : std::string("cannot be written: ") + std::strerror(errno);
    if (ftruncate(file_, end_) != 0) broken_ += " The next run mends the end of the file.";
    throw FileFailure(path_, broken_);
  }
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t length = text.find('\n', from) + 1 - from;
    note(Json::parse(text.substr(from, length)), end_, length);
    end_ += static_cast<off_t>(length);
    from += length;
  }
}

}  // namespace cli
