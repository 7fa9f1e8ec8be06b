// Clause ↔ property ↔ canary, in both directions: every clause of the specification has a test, and every property
// tests a clause.
#include <algorithm>
#include <set>

#include "model/input_error.h"
#include "oracle/subjects/canaries/canaries.h"
#include "properties/clause.h"
#include "properties/property.h"
#include "properties/spec_pages.h"
#include "tests/catch.h"
#include "tests/properties/generated_page.h"
#include "tests/properties/kills.h"

using namespace touchstone;
using properties::Clause;
using properties::Property;

namespace {

bool holds(const std::vector<std::string>& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

}  // namespace

TEST_CASE("ids are unique") {
  std::set<std::string> ids;
  for (const Clause& clause : properties::clauses()) CHECK(ids.insert(clause.id).second);
  for (const Property& property : properties::all()) CHECK(ids.insert(property.id).second);
  for (const auto& canary : oracle::subjects::canaries()) CHECK(ids.insert(canary.id).second);
}

TEST_CASE("ids say where they belong") {
  for (const Property& property : properties::all()) CHECK(property.id.starts_with(property.query + "."));
  for (const Clause& clause : properties::clauses()) {
    std::string query = clause.query;
    std::ranges::transform(query, query.begin(),
                           [](char c) { return c == '_' ? '-' : static_cast<char>(std::toupper(c)); });
    CHECK(clause.id.starts_with("TS-" + query + "-"));
  }
}

TEST_CASE("every tested query has a page, and every page is of a query, in the order of the queries") {
  std::vector<std::string> queries_of_clauses, queries_of_properties;
  for (const Clause& clause : properties::clauses()) queries_of_clauses.push_back(clause.query);
  for (const Property& property : properties::all()) queries_of_properties.push_back(property.query);
  for (std::vector<std::string>* names : {&queries_of_clauses, &queries_of_properties}) {
    names->erase(std::unique(names->begin(), names->end()), names->end());
    CHECK(*names == properties::tested_queries());
  }
  CHECK(properties::spec_pages().size() == properties::tested_queries().size());
}

TEST_CASE("every clause is checked by properties that cite it, of its query") {
  for (const Clause& clause : properties::clauses()) {
    INFO(clause.id);
    CHECK_FALSE(clause.checked_by.empty());
    for (const std::string& id : clause.checked_by) {
      const Property& property = properties::find(id);
      CHECK(property.query == clause.query);
      CHECK(holds(property.clauses, clause.id));
    }
  }
}

TEST_CASE("every property cites clauses that name it") {
  for (const Property& property : properties::all()) {
    INFO(property.id);
    CHECK_FALSE(property.clauses.empty());
    for (const std::string& id : property.clauses) CHECK(holds(properties::clause(id).checked_by, property.id));
  }
}

TEST_CASE("the clauses' page is what the clauses say") {
  CHECK(tests::committed_page("clauses.md", tests::clause_index()) == tests::clause_index());
}

TEST_CASE("an unknown name is an InputError with near names") {
  CHECK_THROWS_WITH(properties::find("distance.symetric"), Catch::Contains("distance.symmetric"));
  CHECK_THROWS_AS(properties::clause("TS-NONE-1"), InputError);
  CHECK_THROWS_AS(oracle::subjects::canary("canary.none"), InputError);
}
