#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "files/spool.h"

namespace cli {

/// Reads a stream, or a file that is compressed by gzip, into a spool; what is not compressed is
/// taken as it is. `check` sees the beginning first, and throws when it is of no use: a device may
/// have no end. Throws FileFailure, also when there is more than this machine has memory.
std::shared_ptr<Spool> unpack(const std::string& path,
                              const std::function<void(std::string_view)>& check);

}  // namespace cli
