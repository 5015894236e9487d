#include <emtr/emtr.h>

#include <string>

#include "c_api/arguments.h"
#include "c_api/guarded.h"
#include "pipeline/result_table.h"

extern "C" {

size_t emtr_result_field_count(void) { return emtr::result_table().size(); }

emtr_status emtr_result_field_describe(size_t index, emtr_result_field_info* info, size_t size) {
  return emtr::guarded([&] {
    const auto& table = emtr::result_table();
    if (index >= table.size())
      throw emtr::Error(
          EMTR_ERROR_ARGUMENT,
          "index is " + std::to_string(index) + ", expected below " + std::to_string(table.size()));
    emtr::hand_out(table[index], info, size);
  });
}

}  // extern "C"
