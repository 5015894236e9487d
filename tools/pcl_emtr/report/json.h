#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>

namespace cli {

using Json = nlohmann::ordered_json;

/// Returns a row-major square matrix as an array of its rows. JSON shows a NaN as null.
template <std::size_t Size, std::size_t Count>
Json rows(const double (&matrix)[Count]) {
  static_assert(Size * Size == Count);
  Json out = Json::array();
  for (std::size_t i = 0; i < Count; i += Size) {
    Json row = Json::array();
    for (std::size_t j = 0; j < Size; ++j) row.push_back(matrix[i + j]);
    out.push_back(row);
  }
  return out;
}

/// Returns the text, or null when it is empty: a file or field that was not asked for.
inline Json text_or_null(const std::string& text) { return text.empty() ? Json() : Json(text); }

}  // namespace cli
