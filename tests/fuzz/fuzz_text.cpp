// Fuzzes text files, as pcl_emtr reads them.
#include "read_cloud.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::read_cloud(".csv", data, size);
  return 0;
}
