#include "options/suggestion.h"

#include <algorithm>
#include <cstddef>

namespace cli {
namespace {

std::string without_dashes(const std::string& word) {
  const std::size_t begin = word.find_first_not_of('-');
  return begin == word.npos ? "" : word.substr(begin);
}

/// Returns how many letters have to be left out, added, replaced or swapped with their neighbor to
/// change `a` into `b` (the optimal string alignment distance).
std::size_t edits_between(const std::string& a, const std::string& b) {
  std::vector<std::vector<std::size_t>> edits(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) edits[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) edits[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i)
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = edits[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      edits[i][j] = std::min({replaced, edits[i - 1][j] + 1, edits[i][j - 1] + 1});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        edits[i][j] = std::min(edits[i][j], edits[i - 2][j - 2] + 1);
    }
  return edits[a.size()][b.size()];
}

/// Returns the number of edits, or one when `word` is the beginning of `known`.
std::size_t distance(const std::string& word, const std::string& known) {
  const bool beginning = word.size() >= 3 && known.compare(0, word.size(), word) == 0;
  const std::size_t edits = edits_between(word, known);
  return beginning ? std::min(edits, std::size_t{1}) : edits;
}

}  // namespace

std::string did_you_mean(const std::string& word, const std::vector<std::string>& known) {
  const std::string plain = without_dashes(word);
  // A third of the letters may be wrong, but never all of them.
  std::size_t allowed = std::min(std::max<std::size_t>(plain.size() / 3, 1) + 1, plain.size());
  std::string nearest;
  for (const auto& candidate : known) {
    const std::size_t edits = distance(plain, without_dashes(candidate));
    if (edits >= allowed) continue;
    allowed = edits;  // a later word has to be nearer
    nearest = candidate;
  }
  return nearest.empty() ? "" : "; did you mean " + nearest + "?";
}

}  // namespace cli
