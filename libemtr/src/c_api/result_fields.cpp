#include <emtr/emtr.h>

#include "c_api/arguments.h"
#include "c_api/guarded.h"
#include "pipeline/result_table.h"

extern "C" {

size_t emtr_result_field_count(void) { return emtr::result_table().size(); }

emtr_status emtr_result_field_describe(size_t index, emtr_result_field_info* info, size_t size) {
  return emtr::guarded([&] {
    const auto& table = emtr::result_table();
    emtr::copy_info(table[emtr::checked_index(index, table.size())], info, size);
  });
}

}  // extern "C"
