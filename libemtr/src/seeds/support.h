#pragma once

#include <cstddef>
#include <vector>

#include "seeds/consistency.h"
#include "util/thread_team.h"

namespace emtr {

/// Returns the support of each correspondence: the sum, over those consistent with it, of how many
/// are consistent with both.
std::vector<std::size_t> support_of_each(const Consistency& consistency, ThreadTeam& team);

}  // namespace emtr
