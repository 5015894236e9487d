#include "report/result_json.h"

#include <cstdint>
#include <cstring>

namespace cli {
namespace {

template <class Value>
Value read(const char* from) {
  Value value;
  std::memcpy(&value, from, sizeof value);
  return value;
}

Json pose_json(const emtr_alternative& pose) {
  return {{"score", pose.score},
          {"surface_fit", pose.surface_fit},
          {"violation", pose.violation},
          {"evidence", pose.evidence},
          {"transformation", rows<4>(pose.transformation)}};
}

/// Returns the element at `from` and moves on to the next one.
Json next_element(emtr_field_type type, const char*& from) {
  const auto take = [&from](auto value) {
    value = read<decltype(value)>(from);
    from += sizeof value;
    return value;
  };
  switch (type) {
    case EMTR_FIELD_REAL:
      return take(double());
    case EMTR_FIELD_INT32:
      return take(std::int32_t());
    case EMTR_FIELD_SWITCH:
      return take(std::int32_t()) != 0;
    // NOLINTNEXTLINE(bugprone-branch-clone): two types on a machine of 32 bits
    case EMTR_FIELD_SIZE:
      return take(std::size_t());
    case EMTR_FIELD_UINT64:
      return take(std::uint64_t());
    case EMTR_FIELD_TEXT:
      return take(static_cast<const char*>(nullptr));
    case EMTR_FIELD_REASON:
      return emtr_reason_name(take(emtr_reason()));
    case EMTR_FIELD_ALTERNATIVE:
      return pose_json(take(emtr_alternative()));
  }
  return Json();
}

Json row_json(emtr_field_type type, const char*& from, std::size_t columns) {
  Json row = Json::array();
  for (std::size_t i = 0; i < columns; ++i) row.push_back(next_element(type, from));
  return row;
}

Json field_json(const emtr_result_field_info& field, const emtr_result& result) {
  const char* const base = reinterpret_cast<const char*>(&result);
  const char* from = base + field.offset;
  if (field.columns == 0) {
    from = read<const char*>(from);
    return row_json(field.type, from, read<std::size_t>(base + field.count_offset));
  }
  if (field.rows > 1) {
    Json matrix = Json::array();
    for (std::size_t i = 0; i < field.rows; ++i)
      matrix.push_back(row_json(field.type, from, field.columns));
    return matrix;
  }
  return field.columns > 1 ? row_json(field.type, from, field.columns)
                           : next_element(field.type, from);
}

}  // namespace

void add_result(Json& out, const emtr_result& result) {
  for (std::size_t i = 0; i < emtr_result_field_count(); ++i) {
    emtr_result_field_info field;
    emtr_result_field_describe(i, &field, sizeof field);
    const std::string group = field.group;
    (group.empty() ? out : out[group])[field.key] = field_json(field, result);
  }
  if (!result.refined) out["refinement"] = Json();
  out["queries"]["total"] =
      result.queries_evaluation + result.queries_switch + result.queries_complement;
}

}  // namespace cli
