// When a run is given up: each limit, one below it and at it.
#include "fast/simulation/stall_guard.h"

#include "tests/catch.h"

namespace touchstone::fast::simulation {
namespace {

std::int64_t work_of(Mark place) {
  const Work work;
  mark(place);
  return work.done();
}
const std::int64_t work_of_a_row = work_of(Mark::contact_row);

/// The iterations at one time after which the guard stops.
int iterations_until_stopped(StallGuard& guard, double now) {
  int iterations = 0;
  while (guard.makes_progress(now, 3, 5)) ++iterations;
  return iterations;
}

TEST_CASE("stall guard: 4000 iterations at one time, and 16 more for each body") {
  for (const std::size_t bodies : {0u, 10u}) {
    StallGuard guard({}, 1, 8, bodies);
    CHECK(iterations_until_stopped(guard, 0) == 4000 + 16 * static_cast<int>(bodies));
    REQUIRE(guard.stopped().has_value());
    CHECK(guard.stopped()->why == "time hardly goes on");
    CHECK(guard.stopped()->a == 3);
    CHECK(guard.stopped()->b == 5);
  }
}

TEST_CASE("stall guard: the count begins again when time leaves the window, 2^-10 of a frame or of the motion") {
  for (const double end : {8.0, 0.5}) {
    const double window = 0x1p-10 * (end < 1 ? end : 1);
    StallGuard guard({}, 1, end, 0);
    for (int i = 0; i < 4000; ++i) REQUIRE(guard.makes_progress(window, 0, 1));  // a window that ends at 2 window
    CHECK(guard.makes_progress(2.5 * window, 0, 1));
    CHECK(iterations_until_stopped(guard, 3 * window) == 3999);
  }
}

TEST_CASE("stall guard: 64 separation queries are an iteration, and lost resolution is 512") {
  StallGuard queries({}, 1, 8, 0), few({}, 1, 8, 0), lost({}, 1, 8, 0);
  queries.count_queries(64 * 100);
  CHECK(iterations_until_stopped(queries, 0) == 3900);
  for (int i = 0; i < 10000; ++i) few.count_queries(63);
  CHECK(iterations_until_stopped(few, 0) == 4000);
  for (int i = 0; i < 7; ++i) lost.count_lost_resolution();
  CHECK(iterations_until_stopped(lost, 0) == 4000 - 7 * 512);
}

TEST_CASE("stall guard: events, micro-bounces and steps up to their limits are allowed") {
  SimulationOptions options;
  options.most_events = 5;
  options.most_micro_bounces = 2;
  options.most_contact_steps = 7;
  StallGuard guard(options, 1, 8, 2);
  Statistics statistics;
  std::int64_t& impacts = statistics.count[static_cast<std::size_t>(Event::Kind::impact)];
  std::int64_t& bounces = statistics.count[static_cast<std::size_t>(Event::Kind::micro_collision)];
  impacts = 3, bounces = 2, statistics.contact_steps = 7;
  guard.check_events(statistics, 1, 0, 1);
  guard.check_steps(statistics, 1, 0, 1);
  CHECK_FALSE(guard.stopped().has_value());
  impacts = 4;
  guard.check_events(statistics, 1, 0, 1);
  REQUIRE(guard.stopped().has_value());
  CHECK(guard.stopped()->why == "more events than allowed");
  impacts = 0, bounces = 3;
  guard.check_events(statistics, 2, 0, 1);
  CHECK_THAT(guard.stopped()->why, Catch::Contains("micro-bounces"));
  statistics.contact_steps = 8;
  guard.check_steps(statistics, 2, 0, 1);
  CHECK_THAT(guard.stopped()->why, Catch::Contains("more steps"));
  CHECK(guard.stopped()->time == 2);
}

TEST_CASE("stall guard: work up to its limit is allowed, counted since the run began") {
  SimulationOptions options;
  options.most_work_per_body = 3 * work_of_a_row;
  mark(Mark::contact_row, 1000);
  StallGuard guard(options, 1, 8, 2);
  mark(Mark::contact_row, 6);
  for (int i = 0; i < 32; ++i) REQUIRE(guard.makes_progress(1, 0, 1));
  mark(Mark::contact_row);
  for (int i = 0; i < 15; ++i) REQUIRE(guard.makes_progress(1.5, 0, 1));  // work is added up in every 16th iteration
  CHECK_FALSE(guard.makes_progress(1.5, 0, 1));
  REQUIRE(guard.stopped().has_value());
  CHECK(guard.stopped()->why == "more work than allowed");
  CHECK(guard.stopped()->time == 1.5);
  guard.check_steps({}, 2, 0, 1);
  CHECK(guard.stopped()->why == "more work than allowed");
  CHECK(guard.stopped()->time == 2);
}

TEST_CASE("stall guard: a residual up to its bound is allowed") {
  StallGuard guard({}, 1, 8, 2);
  guard.check_residual(0.25, 0.25, 3, 0, 1);
  CHECK_FALSE(guard.stopped().has_value());
  guard.check_residual(0.375, 0.25, 3, 0, 1);
  REQUIRE(guard.stopped().has_value());
  CHECK_THAT(guard.stopped()->why, Catch::Contains("could not be solved"));
  CHECK(guard.stopped()->time == 3);
}

}  // namespace
}  // namespace touchstone::fast::simulation
