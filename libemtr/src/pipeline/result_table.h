#pragma once

#include <emtr/emtr.h>

#include <vector>

namespace emtr {

/// Returns every field of emtr_result that says something about the registration, in the order in
/// which a report shows them. The size of the struct and the lengths of its arrays are not rows.
const std::vector<emtr_result_field_info>& result_table();

}  // namespace emtr
