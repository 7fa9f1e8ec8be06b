// Canaries: deliberately wrong subjects, one per kind of defect. A property that catches none of them proves nothing.
//
// Each is a truthful subject with one lie. docs/spec/canaries.md, made by a test, says which property catches which.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "oracle/subject.h"

namespace touchstone::oracle::subjects {

struct Canary {
  std::string id;    ///< "canary.signed_distance"
  std::string says;  ///< the lie, in words
  std::function<std::unique_ptr<Subject>(std::unique_ptr<Subject> truthful)> make;
  std::vector<std::string> lies_about;  ///< queries; to all others it answers the truth
};

const std::vector<Canary>& canaries();

/// Throws InputError listing all of them.
const Canary& canary(const std::string& id);

}  // namespace touchstone::oracle::subjects
