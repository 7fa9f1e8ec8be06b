#include "fast/simulation/statistics.h"

#include "tests/catch.h"

namespace touchstone::fast::simulation {
namespace {

TEST_CASE("statistics: events are counted by kind and in total") {
  Statistics statistics;
  CHECK(statistics.events() == 0);
  statistics.count[static_cast<std::size_t>(Event::Kind::impact)] = 3;
  statistics.count[static_cast<std::size_t>(Event::Kind::force)] = 2;
  CHECK(statistics.of(Event::Kind::impact) == 3);
  CHECK(statistics.of(Event::Kind::force) == 2);
  CHECK(statistics.of(Event::Kind::release) == 0);
  CHECK(statistics.events() == 5);
}

}  // namespace
}  // namespace touchstone::fast::simulation
