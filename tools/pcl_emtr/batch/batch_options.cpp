#include "batch/batch_options.h"

#include <initializer_list>
#include <optional>

#include "failure.h"
#include "files/streams.h"
#include "text/numbers.h"
#include "text/words.h"

namespace cli {
namespace {

constexpr char kGroup[] = "Many pairs";
constexpr std::size_t kMostWorkers = 1024;
constexpr std::size_t kMostMegabytes = std::size_t{1} << 30;

std::size_t whole(const std::string& option, const std::string& text, std::size_t largest) {
  const auto number = parse_unsigned(text);
  if (!number || *number > largest)
    throw UsageFailure(option + ": '" + text + "' is not a whole number from 0 to " +
                       std::to_string(largest));
  return *number;
}

}  // namespace

BatchOptions::BatchOptions(CLI::App& app, Options& options) : app_(app) {
  const auto no_clouds = [&app](const std::string& /*path*/) {
    app.get_option("source")->required(false);
    app.get_option("target")->required(false);
  };
  app.add_option("--batch", options.batch.pairs,
                 wrapped("instead of one pair, register those of this CSV file with the columns "
                         "source and target, perhaps name, and settings (relative paths begin at "
                         "its folder); or of a folder of folders with source.ply and target.ply"))
      ->each(no_clouds)
      ->type_name("FILE")
      ->group(kGroup);
  app.add_option("--out", options.batch.out,
                 wrapped("the folder for results.jsonl, a record a pair, and results.csv; what is "
                         "recorded there is not done again; with --align-all for the poses, the "
                         "pose graph and the model"))
      ->type_name("DIR")
      ->group(kGroup);
  app.add_option("--workers", workers_,
                 wrapped("how many pairs at once, each by --threads threads, which are 1 then "
                         "[from 0 to 1024; default 0, as many as there are processors]"))
      ->type_name("N")
      ->group(kGroup);
  app.add_option("--cache-memory", memory_,
                 wrapped("how many megabytes of preprocessed clouds are kept for later pairs "
                         "[default 1024]"))
      ->type_name("N")
      ->group(kGroup);
  app.add_flag("--retry-errors", options.batch.retry_errors,
               wrapped("try those pairs again that the folder has an error of"))
      ->group(kGroup);
}

void BatchOptions::check(Options& options) const {
  const auto given = [&](const std::string& name) { return app_.get_option(name)->count() > 0; };
  if (!given("--batch")) {
    for (const char* name : {"--out", "--workers", "--cache-memory", "--retry-errors"})
      if (given(name))
        throw UsageFailure(std::string(name) + ": expected --batch" +
                           (std::string(name) == "--out" ? " or --align-all" : "") + " beside it");
    return;
  }
  for (const char* name : {"source", "target", "--output", "--aligned", "--report", "--residuals",
                           "--guess", "--correspondences", "--aligned-format"})
    if (given(name))
      throw UsageFailure(std::string(name) + " and --batch contradict each other: " +
                         "what belongs to one pair is a column of the file, or is not there");
  if (options.batch.pairs.empty())
    throw UsageFailure("--batch: expected a file or folder, got nothing");
  if (!options.html_unit.empty())
    throw UsageFailure("--html-unit and --batch contradict each other: the pages name no unit");
  if (!options.html.empty() && given("--input-format"))
    throw UsageFailure(
        "--input-format and --html with --batch contradict each other: the pages are of files "
        "whose "
        "format is known by their extension");
  if (descriptor_of(options.html))
    throw UsageFailure("--html: expected a folder beside --batch, got '" + options.html + "'");
  if (options.batch.out.empty()) throw UsageFailure("--batch: expected --out for the results");
  options.batch.workers = workers_.empty() ? 0 : whole("--workers", workers_, kMostWorkers);
  const std::size_t megabytes =
      memory_.empty() ? 1024 : whole("--cache-memory", memory_, kMostMegabytes);
  options.batch.cache_bytes = megabytes << 20;
  if (given("--threads")) return;
  emtr_setting_set(&options.settings, "threads", 1);
  for (auto& preset : options.batch.by_preset) emtr_setting_set(&preset.second, "threads", 1);
}

}  // namespace cli
