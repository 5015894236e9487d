#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>

namespace cli {

using Json = nlohmann::ordered_json;

/// A row-major square matrix as an array of its rows; JSON has null for a NaN.
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

}  // namespace cli
