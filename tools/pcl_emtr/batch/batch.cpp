#include "batch/batch.h"

#include <cstdio>
#include <string>
#include <vector>

#include "batch/pages.h"
#include "batch/pairs.h"
#include "batch/record.h"
#include "batch/record_file.h"
#include "batch/status_line.h"
#include "batch/table.h"
#include "batch/workers.h"
#include "failure.h"
#include "interrupt.h"

namespace cli {
namespace {

/// Returns the pairs without a record. Throws when a record is of another run.
std::vector<const Pair*> missing_pairs(const std::vector<Pair>& pairs, const RecordFile& records,
                                       const Options& options) {
  const auto refuse = [&](const std::string& what) {
    throw FileFailure(options.batch.out,
                      what + ": it is of another run; name another folder by --out");
  };
  if (records.last() >= static_cast<std::ptrdiff_t>(pairs.size()))
    refuse("has a record of pair " + std::to_string(records.last()) + ", and there are " +
           std::to_string(pairs.size()) + " pairs");
  std::vector<const Pair*> missing;
  for (const Pair& pair : pairs) {
    if (!records.has(pair.index)) {
      missing.push_back(&pair);
      continue;
    }
    const auto difference =
        record_difference(records.read(pair.index), pair, options.viewpoints_from_files);
    if (!difference.empty())
      refuse("the record of pair " + std::to_string(pair.index) + " " + difference);
  }
  return missing;
}

int exit_code(const RecordFile::Counts& counts) {
  if (counts.errors) return kInputOutput;
  return counts.not_registered ? kNotRegistered : kRegistered;
}

}  // namespace

int run_batch(const Options& options) {
  const std::vector<Pair> pairs = read_pairs(options);
  require_pages(options);
  RecordFile records(options.batch.out, options.batch.retry_errors);
  const auto missing = missing_pairs(pairs, records, options);
  {
    const Interrupt interrupt;
    StatusLine status(options.quiet, pairs.size(), records.counts().all());
    work_on(missing, options, records, status);
  }
  const RecordFile::Counts counts = records.counts();
  const bool stopped = counts.all() < pairs.size();
  if (!stopped) write_table(records);
  if (!options.quiet)
    std::fprintf(
        stderr, "%zu of %zu pairs: %zu registered, %zu not registered, %zu errors; %s\n",
        counts.all(), pairs.size(), counts.registered, counts.not_registered, counts.errors,
        stopped ? "stopped, the same command goes on" : ("in '" + options.batch.out + "'").c_str());
  if (stopped) return kSignal + Interrupt::number();
  const int pages = options.html.empty() ? 0 : make_pages(options);
  return pages ? pages : exit_code(counts);
}

}  // namespace cli
