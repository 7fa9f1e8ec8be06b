// The queries: what a subject can be asked. Every list of their names is made from this one.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "oracle/subject.h"

namespace touchstone::oracle {

/// A query as a member of Subject: &Subject::distance.
template <class T>
using QueryFunction = Answer<T> (Subject::*)(const Scene&);

/// A part of a scene that only some queries use.
enum class ScenePart { none, contact, raster, motion };

/// The name of a query, the function that answers it, and what a scene must have.
struct Query {
  std::string name;  ///< in the protocol, on a card, and as the first part of a property's id
  std::variant<QueryFunction<Masses>, QueryFunction<Bounds>, QueryFunction<PairSet>, QueryFunction<PairHistory>,
               QueryFunction<Distance>, QueryFunction<Penetration>, QueryFunction<Pixels>, QueryFunction<Impulse>,
               QueryFunction<TimeOfImpact>, QueryFunction<Trajectory>>
      ask;
  bool about_two_bodies = false;      ///< bodies 0 (A) and 1 (B); a scene may have further ones
  ScenePart needs = ScenePart::none;  ///< besides the bodies
};

/// All queries, in the order of reports.
const std::vector<Query>& queries();
std::vector<std::string> query_names();

/// Null if no query has this name.
const Query* find_query(const std::string& name);

}  // namespace touchstone::oracle
