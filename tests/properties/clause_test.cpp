// The reader of clauses: the format, and each way to violate it.
#include "properties/clause.h"

#include "model/input_error.h"
#include "tests/catch.h"

using namespace touchstone;
using properties::parse_clauses;

namespace {

const std::string good =
    "# Page\n\nWords.\n\n### TS-X-1 · Title of it\nThe sentence\ngoes on.\n"
    "- **Domain** all. **Truth** exact. **Allowed** `tolerance::x`.\n- **Freedom** some.\n"
    "- **Source** a book.  **Checked by** `x.a`, `x.b`.  **Proved sharp by** `canary.c`.\n";

std::string without(const std::string& part) {
  std::string page = good;
  page.erase(page.find(part), part.size());
  return page;
}

}  // namespace

TEST_CASE("a clause in the house's form") {
  const auto clauses = parse_clauses(good + good, "x");
  REQUIRE(clauses.size() == 2);
  const properties::Clause& clause = clauses[1];
  CHECK(clause.id == "TS-X-1");
  CHECK(clause.query == "x");
  CHECK(clause.title == "Title of it");
  CHECK(clause.says == "The sentence goes on.");
  CHECK(clause.domain == "all.");
  CHECK(clause.allowed == "`tolerance::x`.");
  CHECK(clause.freedom == "some.");
  CHECK(clause.source == "a book.");
  CHECK(clause.checked_by == std::vector<std::string>{"x.a", "x.b"});
  CHECK(clause.sharp_by == std::vector<std::string>{"canary.c"});
}

TEST_CASE("Freedom may be left out, nothing else") {
  CHECK(parse_clauses(without("- **Freedom** some.\n"), "x")[0].freedom.empty());
  CHECK_THROWS_WITH(parse_clauses(without("**Truth** exact. "), "x"), Catch::Contains("TS-X-1: no Truth"));
  CHECK_THROWS_WITH(parse_clauses(without("The sentence\ngoes on.\n"), "x"), Catch::Contains("no sentence"));
  CHECK_THROWS_WITH(parse_clauses(without(" · Title of it"), "x"), Catch::Contains("no title"));
}

TEST_CASE("unknown, repeated and open keys are named") {
  CHECK_THROWS_WITH(parse_clauses(good + "**Wish** more.\n", "x"), Catch::Contains("unknown key Wish"));
  CHECK_THROWS_WITH(parse_clauses(good + "**Truth** twice.\n", "x"), Catch::Contains("Truth stands twice"));
  CHECK_THROWS_WITH(parse_clauses(good + "**Trut", "x"), Catch::Contains("not closed"));
}
