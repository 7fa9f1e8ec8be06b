// A documentation page that a test generates: the committed copy must equal the generated page.
#pragma once

#include <cstdlib>
#include <string>

#include "model/json.h"

namespace touchstone::tests {

/// Reads docs/spec/<name>. If TOUCHSTONE_UPDATE is set, writes `made` to it first.
inline std::string committed_page(const std::string& name, const std::string& made) {
  // One literal: for some lengths of the folder's name g++ 12 warns of a sum of strings (GCC bug 105651).
  const std::string path = TOUCHSTONE_SOURCE_DIR "/docs/spec/" + name;
  if (std::getenv("TOUCHSTONE_UPDATE") != nullptr) write_text(path, made);
  return read_text(path);
}

}  // namespace touchstone::tests
