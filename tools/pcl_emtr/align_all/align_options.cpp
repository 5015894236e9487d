#include "align_all/align_options.h"

#include <algorithm>
#include <array>
#include <string>

#include "failure.h"
#include "files/streams.h"
#include "text/words.h"

namespace cli {
namespace {

constexpr char kName[] = "--align-all";

/// The options that pyemtr-align takes too, by the same names.
constexpr std::array<const char*, 6> kPassedOn = {"--out",     "--preset", "--seed",
                                                  "--threads", "--quiet",  "--html"};

bool is_passed_on(const std::string& name) {
  return std::find(kPassedOn.begin(), kPassedOn.end(), name) != kPassedOn.end();
}

}  // namespace

AlignOptions::AlignOptions(CLI::App& app, Options& options) : app_(app) {
  const auto no_clouds = [&app](const std::string& /*path*/) {
    app.get_option("source")->required(false);
    app.get_option("target")->required(false);
  };
  app.add_option(kName, options.align.scans,
                 wrapped("instead of one pair, bring all scans of this folder into one frame, in "
                         "any order and from any pose; runs pyemtr-align of the Python package "
                         "(pip install 'pyemtr[align]'), which takes --out, --preset, --seed, "
                         "--threads, --quiet and --html"))
      ->each(no_clouds)
      ->type_name("DIR")
      ->group("Many scans");
}

bool AlignOptions::check(Options& options) const {
  if (!app_.get_option(kName)->count()) return false;
  if (options.align.scans.empty())
    throw UsageFailure(std::string(kName) + ": expected a folder of scans, got nothing");
  if (!app_.get_option("--out")->count())
    throw UsageFailure(std::string(kName) + ": expected --out for the poses and the model");
  if (descriptor_of(options.html))
    throw UsageFailure("--html: expected a folder beside " + std::string(kName) + ", got '" +
                       options.html + "'");
  for (const CLI::Option* option : app_.get_options()) {
    const std::string name = option->get_name();
    if (!option->count() || name == kName) continue;
    if (!is_passed_on(name))
      throw UsageFailure(name + " and " + kName +
                         " contradict each other; pyemtr-align --help lists what it takes");
    options.align.arguments.push_back(name);
    // A flag has the result "true", and pyemtr-align takes no value for it.
    if (option->get_items_expected_max() > 0)
      for (const auto& value : option->results()) options.align.arguments.push_back(value);
  }
  return true;
}

}  // namespace cli
