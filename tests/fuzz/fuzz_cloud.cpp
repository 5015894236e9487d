// One cloud on its way in: reading, validation, the frame.
#include <emtr/emtr.h>

#include <memory>
#include <string>

#include "any_cloud.h"
#include "calls.h"
#include "input.h"

namespace {

using fuzz::accepted;
using fuzz::require;

void prepare(const emtr_cloud& cloud, const std::string& name) {
  emtr_prepared* prepared = nullptr;
  if (!accepted(emtr_prepare(&cloud, name.c_str(), 1, &prepared))) {
    require(prepared == nullptr);
    return;
  }
  const std::unique_ptr<emtr_prepared, decltype(&emtr_prepared_free)> owned(prepared,
                                                                            emtr_prepared_free);
  emtr_prepared_info info;
  require(accepted(emtr_prepared_describe(prepared, &info, sizeof info)));
  require(info.points + info.dropped == cloud.count && info.points >= 10);
  require(info.kept == info.points);  // far too few to be thinned
  require(std::isfinite(info.radius) && info.radius > 0);
  for (const double value : info.center) require(std::isfinite(value));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Input input(data, size);
  const std::string name = input.ConsumeRandomLengthString(8);
  const fuzz::AnyCloud cloud(input, 64);
  prepare(cloud.view(), name);

  // A view that contradicts itself is refused before its memory is touched.
  emtr_cloud wrong = cloud.view();
  const std::size_t packed = wrong.scalar == EMTR_FLOAT32 ? 12 : 24;
  if (input.ConsumeBool()) {
    wrong.stride = input.ConsumeIntegralInRange<std::size_t>(1, packed - 1);
  } else {
    wrong.points = nullptr;
    wrong.count = input.ConsumeIntegralInRange<std::size_t>(1, SIZE_MAX);
  }
  emtr_prepared* prepared = nullptr;
  require(!accepted(emtr_prepare(&wrong, nullptr, 1, &prepared)));
  return 0;
}
