// A page of digests, one line for each thing whose bits must not change unless a change means it.
#pragma once

#include <cstdint>
#include <cstdio>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "tests/properties/generated_page.h"

namespace touchstone::tests {

/// FNV-1a, of all text added.
class Digest {
 public:
  void add(std::string_view text) {
    for (const char c : text) hash_ = (hash_ ^ static_cast<unsigned char>(c)) * 1099511628211u;
  }
  std::string text() const {
    char digits[17];
    std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash_));
    return digits;
  }

 private:
  std::uint64_t hash_ = 14695981039346656037u;
};

/// The lines in which `made` differs from the committed tests/properties/pins/<name>: "- " with a line of the file, "+
/// " with one of `made`. No line is twice in a page.
inline std::vector<std::string> changed_lines(const std::string& name, const std::string& made) {
  const auto lines_of = [](const std::string& page) {
    std::istringstream text(page);
    std::set<std::string> lines;
    for (std::string line; std::getline(text, line);) lines.insert(line);
    return lines;
  };
  const std::set<std::string> pinned =
      lines_of(committed_text(TOUCHSTONE_SOURCE_DIR "/tests/properties/pins/" + name, made));
  const std::set<std::string> now = lines_of(made);
  std::vector<std::string> changed;
  for (const std::string& line : pinned) {
    if (!now.contains(line)) changed.push_back("- " + line);
  }
  for (const std::string& line : now) {
    if (!pinned.contains(line)) changed.push_back("+ " + line);
  }
  return changed;
}

}  // namespace touchstone::tests
