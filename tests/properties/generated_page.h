// A page of docs that a test makes: the committed copy must be what the test makes now.
#pragma once

#include <cstdlib>
#include <string>

#include "model/json.h"

namespace touchstone::tests {

/// Reads docs/spec/<name>; with TOUCHSTONE_UPDATE set, writes `made` there first.
inline std::string committed_page(const std::string& name, const std::string& made) {
  const std::string path = std::string(TOUCHSTONE_SOURCE_DIR) + "/docs/spec/" + name;
  if (std::getenv("TOUCHSTONE_UPDATE") != nullptr) write_text(path, made);
  return read_text(path);
}

}  // namespace touchstone::tests
