// A property is one executable sentence: a pure function (Scene, Subject) -> Finding that cites clauses.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "model/scene.h"
#include "oracle/finding.h"
#include "oracle/subject.h"

namespace touchstone::properties {

/// `check` asks the subject, once or more often, and judges what it answers. Requires a completed scene
/// (reference/validity.h); one outside the clause's domain has the outcome `outside`.
struct Property {
  std::string id;                    ///< "distance.symmetric"
  std::string query;                 ///< "distance"
  std::vector<std::string> clauses;  ///< "TS-DISTANCE-2"
  std::string says;                  ///< the sentence
  std::function<oracle::Finding(const Scene&, oracle::Subject&)> check;
};

/// All properties, in the order of the queries and, within one, of the five families.
const std::vector<Property>& all();

/// The names of the queries that have properties, in the order of oracle/query.h.
const std::vector<std::string>& tested_queries();

/// Throws InputError with a list of similar names if there is no such property.
const Property& find(const std::string& id);

}  // namespace touchstone::properties
