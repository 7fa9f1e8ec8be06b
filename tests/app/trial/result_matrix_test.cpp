// The matrix of results: each row is at its property and subject, and a part of a run is merged into the right rows.
#include "app/trial/result_matrix.h"

#include <stdexcept>

#include "tests/catch.h"

namespace touchstone::app {
namespace {

using properties::Property;

const std::vector<Property> four = {
    {"a.one", "a", {}, "", {}}, {"a.two", "a", {}, "", {}}, {"b.one", "b", {}, "", {}}, {"c.one", "c", {}, "", {}}};
const std::vector<TestedSubject> subjects = {{0, {}, "exec:first", "first"}, {1, {}, "exec:second", "second"}};

ResultMatrix whole() { return {{&four[0], &four[1], &four[2]}, subjects}; }

TEST_CASE("Rows come by property and by subject, in the order of both") {
  ResultMatrix matrix = whole();
  REQUIRE(matrix.all().size() == 6);
  for (const Property* property : matrix.tested_properties()) {
    for (const TestedSubject& subject : subjects) {
      const Row& row = matrix.at(*property, subject);
      CHECK(row.property == property);
      CHECK(row.subject == &subject);
      CHECK(&matrix.of(*property)[subject.index] == &row);
    }
  }
  const std::vector<const Row*> of_second = matrix.of(subjects[1]);
  REQUIRE(of_second.size() == 3);
  for (std::size_t p = 0; p < 3; ++p) CHECK(of_second[p] == &matrix.at(four[p], subjects[1]));
}

TEST_CASE("A part about some of the properties is added to their rows") {
  ResultMatrix matrix = whole();
  matrix.at(four[2], subjects[1]).counts.holds = 5;
  ResultMatrix part({&four[2], &four[1]}, subjects);
  part.at(four[2], subjects[1]).counts.holds = 2;
  part.at(four[1], subjects[0]).counts.fails = 3;
  matrix.merge(part);
  CHECK(matrix.at(four[2], subjects[1]).counts.holds == 7);
  CHECK(matrix.at(four[1], subjects[0]).counts.fails == 3);
  long sum = 0;
  for (const Row& row : matrix.all()) sum += row.answered();
  CHECK(sum == 10);
}

TEST_CASE("What is not in the matrix is refused") {
  ResultMatrix matrix = whole();
  const std::vector<TestedSubject> others = subjects;
  CHECK_THROWS_AS(matrix.of(four[3]), std::out_of_range);
  CHECK_THROWS_AS(matrix.at(four[3], subjects[0]), std::out_of_range);
  CHECK_THROWS_AS(matrix.at(four[0], others[0]), std::out_of_range);
}

}  // namespace
}  // namespace touchstone::app
