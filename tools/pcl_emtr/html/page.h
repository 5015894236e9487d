#pragma once

#include <emtr/emtr.h>

#include <string>

#include "options/options.h"
#include "read/cloud_file.h"
#include "report/json.h"

namespace cli {

/// Returns a page to look at: one file for a browser, which loads nothing. It is the template of
/// pyemtr/html with the report, the points and their residuals inside. Throws Failure.
std::string html_page(const Options& options, const CloudFile& source, const CloudFile& target,
                      const emtr_result& result, const Json& report);

}  // namespace cli
