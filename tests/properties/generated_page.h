// A file that a test generates: the committed copy must equal what is generated.
#pragma once

#include <cstdlib>
#include <string>

#include "model/json.h"

namespace touchstone::tests {

/// Reads the file. If TOUCHSTONE_UPDATE is set, writes `made` to it first.
inline std::string committed_text(const std::string& path, const std::string& made) {
  if (std::getenv("TOUCHSTONE_UPDATE") != nullptr) write_text(path, made);
  return read_text(path);
}

/// That of docs/spec/<name>.
inline std::string committed_page(const std::string& name, const std::string& made) {
  // One literal: for some lengths of the folder's name g++ 12 warns of a sum of strings (GCC bug 105651).
  return committed_text(TOUCHSTONE_SOURCE_DIR "/docs/spec/" + name, made);
}

}  // namespace touchstone::tests
