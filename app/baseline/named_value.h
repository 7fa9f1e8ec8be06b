// A value of an enumeration, by its name in a file.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "model/json_node.h"
#include "model/near_names.h"
#include "oracle/finding.h"
#include "oracle/judge/grade.h"

namespace touchstone::app {

/// From `first` to `last`, as name_of calls them. Refuses any other name, and says which is meant.
template <class Name>
Name read_named(const Node& node, Name first, Name last) {
  std::vector<std::string> names;
  for (int i = static_cast<int>(first); i <= static_cast<int>(last); ++i) {
    names.push_back(oracle::name_of(static_cast<Name>(i)));
  }
  const std::string word = node.text();
  const auto found = std::ranges::find(names, word);
  if (found == names.end()) node.refuse(Json(word).dump() + " is " + unknown_among(word, names));
  return static_cast<Name>(static_cast<int>(first) + static_cast<int>(found - names.begin()));
}

}  // namespace touchstone::app
