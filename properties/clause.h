// A Clause is one numbered sentence of the specification, read from docs/spec (which the build takes into the program).
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace touchstone::properties {

struct Clause {
  std::string id;     ///< "TS-DISTANCE-2"
  std::string stem;   ///< "distance": the page's name
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

/// The clauses of one page, in its form:
///
///   ### TS-STEM-1 · Title
///   The sentence.
///   - **Domain** … **Truth** … **Allowed** …
///   - **Freedom** …
///   - **Source** …  **Checked by** `property`, ….  **Proved sharp by** `canary`, ….
///
/// Freedom may be left out. Throws InputError naming the page and the clause for a key that is unknown, missing or
/// twice.
std::vector<Clause> parse_clauses(std::string_view page, const std::string& stem);

/// All clauses, in the order of the stems and the pages.
const std::vector<Clause>& clauses();

/// Throws InputError if there is none.
const Clause& clause(const std::string& id);

}  // namespace touchstone::properties
