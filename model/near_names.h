// Suggestions for a word that is not a known name: the names that were probably meant.
#pragma once

#include <string>
#include <vector>

namespace touchstone {

/// "did you mean a, b or c?" with the names closest to the word, closest first, at most three. Empty if none is close.
std::string did_you_mean(const std::string& word, const std::vector<std::string>& names);

/// "unknown; did you mean a? There are a, b, c": for lists that are short enough to print.
std::string unknown_among(const std::string& word, const std::vector<std::string>& names);

}  // namespace touchstone
