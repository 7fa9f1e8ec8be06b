// The work of a run: counts since it began, times what each costs.
#include "fast/simulation/work.h"

#include "tests/catch.h"

namespace touchstone::fast::simulation {
namespace {

TEST_CASE("work: counts from its own beginning, and in proportion") {
  const Work all;
  mark(Mark::toi_query);
  const std::int64_t one = all.done();
  CHECK(one > 0);
  const Work rest;
  CHECK(rest.done() == 0);
  mark(Mark::toi_query, 2);
  CHECK(rest.done() == 2 * one);
  CHECK(all.done() == 3 * one);
}

TEST_CASE("work: what is left out does not count") {
  Work work;
  mark(Mark::toi_query);
  const std::int64_t one = work.done();
  const MarkCounts before = mark_counts;
  mark(Mark::toi_query, 5);
  mark(Mark::contact_round);
  work.leave_out(marks_since(before));
  CHECK(work.done() == one);
}

TEST_CASE("work: what costs more counts more") {
  const auto of = [](Mark place) {
    const Work work;
    mark(place);
    return work.done();
  };
  CHECK(of(Mark::contact_row) < of(Mark::contact_round));
  CHECK(of(Mark::toi_query) < of(Mark::exact_proximity));
  CHECK(of(Mark::pixel_seen) == 0);  // no part of a run
}

}  // namespace
}  // namespace touchstone::fast::simulation
