// Words of the command line become subjects, or a message that says why not.
#include "app/trial/subject_list.h"

#include "model/input_error.h"
#include "tests/catch.h"

namespace touchstone::app {
namespace {

using Names = std::vector<std::string>;

TEST_CASE("Commas part names, but belong to a command line") {
  CHECK(subject_list({"a,b", "c"}) == Names{"a", "b", "c"});
  CHECK(subject_list({"exec:engine --flag x,y"}) == Names{"exec:engine --flag x,y"});
  CHECK(subject_list({"a,exec:engine x,y"}) == Names{"a", "exec:engine x,y"});
}

TEST_CASE(
    "A subject may sleep for ten times its CPU time, and for 10 s at least, since a busy machine starts it late") {
  CHECK(limits_of(0.25).cpu_seconds == 0.25);
  CHECK(limits_of(0.25).wall_seconds == 10);
  CHECK(limits_of(2).wall_seconds == 20);
}

TEST_CASE("Subjects that are linked in") {
  CHECK(connect("inproc:reference", {})->card().name == "reference");
  CHECK(connect("inproc:fast", {})->card().name == "fast");
  CHECK_THROWS_WITH(connect("inproc:bullet", {}), Catch::Contains("inproc:bullet") && Catch::Contains("inproc:fast"));
}

TEST_CASE("Names that are none") {
  CHECK_THROWS_AS(connect("", {}), InputError);
  CHECK_THROWS_AS(connect("no_such_engine", {}), InputError);
  CHECK_THROWS_AS(connect("exec:", {}), InputError);
  CHECK_THROWS_AS(connect("../subjects/touchstone-subject-fast", {}), InputError);
}

}  // namespace
}  // namespace touchstone::app
