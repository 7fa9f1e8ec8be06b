// A page of digests, one line for each thing whose bits must not change unless a change means it.
#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "model/json.h"

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

/// Reads tests/properties/pins/<name>. If TOUCHSTONE_UPDATE is set, writes `made` to it first.
inline std::string pinned_page(const std::string& name, const std::string& made) {
  const std::string path = TOUCHSTONE_SOURCE_DIR "/tests/properties/pins/" + name;
  if (std::getenv("TOUCHSTONE_UPDATE") != nullptr) write_text(path, made);
  return read_text(path);
}

/// The lines of one page that the other does not have.
inline std::vector<std::string> lines_not_in(const std::string& other, const std::string& page) {
  const std::string there = '\n' + other;
  std::istringstream lines(page);
  std::vector<std::string> missing;
  for (std::string line; std::getline(lines, line);) {
    if (there.find('\n' + line + '\n') == std::string::npos) missing.push_back(line);
  }
  return missing;
}

}  // namespace touchstone::tests
