#pragma once

namespace cli {

/// Returns the page of pyemtr/html/template with its style and scripts inside, and "@payload@"
/// where the data go. CMake makes the source of it, see template.cmake.
const char* html_template();

}  // namespace cli
