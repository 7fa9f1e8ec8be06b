// A clause is one numbered sentence of the specification, read from docs/spec (which the build embeds in the program).
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace touchstone::properties {

/// One clause; the texts are those of the page.
struct Clause {
  std::string id;     ///< "TS-DISTANCE-2"
  std::string query;  ///< "distance": the page's name
  std::string title;  ///< "Symmetry"
  std::string says;   ///< the sentence
  std::string domain;
  std::string truth;
  std::string allowed;
  std::string freedom;  ///< what the specification leaves open; may be empty
  std::string source;
  std::vector<std::string> checked_by;  ///< properties
  std::vector<std::string> sharp_by;    ///< canaries
};

/// Reads the clauses of one page, which has this form:
///
///   ### TS-QUERY-1 · Title
///   The sentence.
///   - **Domain** … **Truth** … **Allowed** …
///   - **Freedom** …
///   - **Source** …  **Checked by** `property`, ….  **Proved sharp by** `canary`, ….
///
/// Freedom may be left out. Throws InputError with the page and the clause for a key that is unknown, missing or
/// repeated.
std::vector<Clause> parse_clauses(std::string_view page, const std::string& query);

/// All clauses, in the order of the queries and the pages.
const std::vector<Clause>& clauses();

/// Throws InputError if there is no such clause.
const Clause& clause(const std::string& id);

}  // namespace touchstone::properties
