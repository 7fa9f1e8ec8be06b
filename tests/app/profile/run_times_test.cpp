// Times are counted in classes: quantiles within half a class, whatever the order of merging.
#include "app/profile/run_times.h"

#include "tests/catch.h"

namespace touchstone::app {
namespace {

constexpr double half_a_class = 0.022;  // 2^(1/32) − 1

TEST_CASE("A quantile of times is within half a class") {
  RunTimes times;
  for (int i = 1; i <= 1000; ++i) times.count(1e-6 * i);
  CHECK(times.total() == 1000);
  CHECK(times.quantile(0.1) == Approx(100e-6).epsilon(2 * half_a_class));
  CHECK(times.quantile(0.5) == Approx(500e-6).epsilon(2 * half_a_class));
  CHECK(times.quantile(1) == Approx(1000e-6).epsilon(2 * half_a_class));
}

TEST_CASE("Merged times are those of both") {
  RunTimes all, first, second;
  for (int i = 1; i <= 100; ++i) {
    all.count(1e-3 * i);
    (i % 3 == 0 ? first : second).count(1e-3 * i);
  }
  second.merge(first);
  CHECK(second.classes == all.classes);
}

TEST_CASE("A clock that did not advance counts as a nanosecond") {
  RunTimes times;
  times.count(0);
  CHECK(times.total() == 1);
  CHECK(times.quantile(0.5) == Approx(1e-9).epsilon(half_a_class));
}

}  // namespace
}  // namespace touchstone::app
