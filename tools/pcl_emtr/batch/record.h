#pragma once

#include <emtr/emtr.h>

#include <string>

#include "batch/pair.h"
#include "report/json.h"

namespace cli {

// The record of a pair, as docs/MANY_PAIRS.md describes it.

/// Returns the record of a pair with a result; `settings` are those that it was registered with.
Json result_record(const Pair& pair, const emtr_settings& settings, const emtr_result& result);

/// Returns the record of a pair that could not be registered.
Json error_record(const Pair& pair, const std::string& error);

/// Returns the record as one line, with its line break. Bytes that are not UTF-8 are replaced.
std::string record_line(const Json& record);

/// Returns why the record cannot be one of this pair with these settings, or "". `any_viewpoints`:
/// these come from the files.
std::string record_difference(const Json& record, const Pair& pair, bool any_viewpoints);

}  // namespace cli
