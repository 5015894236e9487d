#pragma once

#include <memory>

#include "pipeline/registration.h"

namespace emtr_test {

/// What a registration of two clouds gives, from the clouds in the user's memory on.
inline std::unique_ptr<emtr::Result> registered(const emtr_cloud& source, const emtr_cloud& target,
                                                const emtr::Settings& settings,
                                                const emtr::OnProgress& on_progress = nullptr) {
  emtr::InputCloud from{&source, nullptr}, to{&target, nullptr};
  emtr::CancellationToken token(on_progress);
  return emtr::register_clouds(from, to, settings, token);
}

}  // namespace emtr_test
