#include "app/system/file_names.h"

#include <algorithm>
#include <functional>
#include <set>

namespace touchstone::app {
namespace {

constexpr std::size_t longest = 64;  // with property, number and suffix, well below the 255 of file systems

bool is_between(char c, char first, char last) { return first <= c && c <= last; }

bool is_harmless(char c) {
  return is_between(c, 'a', 'z') || is_between(c, 'A', 'Z') || is_between(c, '0', '9') || c == '.' || c == '-';
}

std::string folded(std::string name) {
  std::ranges::replace_if(name, std::not_fn(is_harmless), '_');
  return name.substr(0, longest);
}

std::string in_lower_case(std::string name) {
  for (char& c : name) {
    if (is_between(c, 'A', 'Z')) c = static_cast<char>(c - 'A' + 'a');
  }
  return name;
}

}  // namespace

std::vector<std::string> names_of_files(const std::vector<oracle::Card>& cards) {
  std::set<std::string> taken;
  std::vector<std::string> names;
  for (const oracle::Card& card : cards) {
    const std::string wanted = folded(card.name);
    std::string name = wanted;
    for (int number = 2; !taken.insert(in_lower_case(name)).second; ++number)
      name = wanted + '-' + std::to_string(number);
    names.push_back(name);
  }
  return names;
}

}  // namespace touchstone::app
