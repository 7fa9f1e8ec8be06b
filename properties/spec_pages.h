// The pages of docs/spec as text in the program. properties/CMakeLists.txt generates spec_pages.cpp from them.
#pragma once

#include <string_view>
#include <vector>

namespace touchstone::properties {

/// One page: the query that it is named after, and its Markdown.
struct SpecPage {
  std::string_view query;
  std::string_view text;
};

/// Sorted by name.
const std::vector<SpecPage>& spec_pages();

}  // namespace touchstone::properties
