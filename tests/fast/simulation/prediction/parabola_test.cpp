// Closing times by hand, and of points so far away that the plain discriminant has no bit left.
#include "fast/simulation/prediction/parabola.h"

#include "tests/catch.h"

namespace touchstone::fast::simulation {
namespace {

TEST_CASE("parabola: the gap closes at the first root with a falling gap") {
  CHECK(closing_time(6, -2, 0) == 3);      // 6 − 2t
  CHECK(closing_time(5, 0, -10) == 1);     // falls 5 m at 10 m/s²
  CHECK(closing_time(15, 10, -10) == 3);   // thrown up first: 15 + 10t − 5t²
  CHECK(closing_time(6, -5, 2) == 2);      // 6 − 5t + t² = (t − 2)(t − 3)
  CHECK(closing_time(7, -5, 2) == never);  // its lowest value is 0.75
  CHECK(closing_time(1, 1, 0) == never);
  CHECK(closing_time(1, 0, 0) == never);
}

TEST_CASE("parabola: a gap that is closed already closes at once if it falls, or when it stops rising") {
  CHECK(closing_time(0, -1, 5) == 0);
  CHECK(closing_time(-1, -1, 0) == 0);
  CHECK(closing_time(0, 0, -2) == 0);
  CHECK(closing_time(0, 0, 0) == never);
  CHECK(closing_time(0, 4, -2) == 4);   // 4t − t²: open until 4
  CHECK(closing_time(-5, 4, -2) == 2);  // never opens; rises until 2
  CHECK(closing_time(-1, 1, 0) == never);
}

TEST_CASE("parabola: a point reaches a sphere") {
  CHECK(sphere_closing_time({3, 0, 0}, {-1, 0, 0}, 1) == 2);
  CHECK(sphere_closing_time({3, 4, 0}, {-1, 0, 0}, 5) == Approx(0).margin(1e-15));
  CHECK(sphere_closing_time({10, 3, 0}, {-2, 0, 0}, 5) == Approx(3));  // 3-4-5: reached at x = 4
  CHECK(sphere_closing_time({10, 6, 0}, {-2, 0, 0}, 5) == never);
}

TEST_CASE("parabola: a far point still hits or misses by its distance of passing") {
  // At x = 2^40 the square of the distance has no bit for a radius of 1. Passing at 0.75, then at 1.25.
  CHECK(sphere_closing_time({0x1p40, 0.75, 0}, {-1, 0, 0}, 1) == Approx(0x1p40).epsilon(1e-12));
  CHECK(sphere_closing_time({0x1p40, 1.25, 0}, {-1, 0, 0}, 1) == never);
}

TEST_CASE("parabola: a point as slow as can be reaches the sphere, late") {
  CHECK(sphere_closing_time({3, 0, 0}, {-0x1p-300, 0, 0}, 1) == 0x1p301);
}

}  // namespace
}  // namespace touchstone::fast::simulation
