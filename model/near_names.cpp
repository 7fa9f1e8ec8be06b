#include "model/near_names.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace touchstone {
namespace {

constexpr std::size_t longest_word = 64;  // a longer word is not a typing error
constexpr std::size_t shortest_part = 3;

/// The last row of the Levenshtein distance, the number of letters to change, add or drop. `row` holds, for each prefix
/// of b, its distance from the empty word.
std::vector<std::size_t> last_row(const std::string& a, const std::string& b, std::vector<std::size_t> row) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t kept = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({kept, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row;
}

std::size_t edits(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  return last_row(a, b, row).back();
}

/// The distance from `part` to the part of `whole` that is closest to it.
std::size_t edits_to_a_part(const std::string& part, const std::string& whole) {
  return std::ranges::min(last_row(part, whole, std::vector<std::size_t>(whole.size() + 1)));
}

bool is_part(const std::string& part, const std::string& whole) {
  return part.size() >= shortest_part && edits_to_a_part(part, whole) <= part.size() / 4;
}

std::string joined(const std::vector<std::string>& names, const std::string& last_separator) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 == names.size() ? last_separator : ", ";
    text += names[i];
  }
  return text;
}

}  // namespace

std::string did_you_mean(const std::string& word, const std::vector<std::string>& names) {
  if (word.size() > longest_word) return "";
  std::vector<std::pair<std::size_t, std::string>> ranked;
  for (const std::string& name : names) {
    const std::size_t wrong = edits(word, name);
    const bool is_near = wrong <= (word.size() + 2) / 3;
    if (is_near || is_part(word, name) || is_part(name, word)) ranked.emplace_back(wrong, name);
  }
  std::ranges::sort(ranked);
  std::vector<std::string> nearest;
  for (const auto& [wrong, name] : ranked) {
    if (nearest.size() < 3) nearest.push_back(name);
  }
  return nearest.empty() ? "" : "did you mean " + joined(nearest, " or ") + "?";
}

std::string unknown_among(const std::string& word, const std::vector<std::string>& names) {
  const std::string suggestion = did_you_mean(word, names);
  const std::string there_are = "here are " + joined(names, ", ");
  return "unknown; " + (suggestion.empty() ? "t" + there_are : suggestion + " T" + there_are);
}

}  // namespace touchstone
