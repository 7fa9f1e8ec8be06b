// The nearer a scene is to a failure, the longer it is kept, and the more often it is chosen.
#include "app/fuzz/pool.h"

#include "tests/catch.h"

namespace touchstone::app {
namespace {

Scene named(const std::string& name) {
  Scene scene;
  scene.name = name;
  return scene;
}

TEST_CASE("A full pool loses scenes that are far from a failure") {
  Pool pool;
  properties::Random random(1);
  for (std::size_t i = 0; i < Pool::most; ++i) pool.keep(named("far"), -50, random);
  for (std::size_t i = 0; i < Pool::most / 2; ++i) pool.keep(named("near"), -1, random);
  CHECK(pool.size() == Pool::most);
  int near = 0;
  for (int i = 0; i < 1000; ++i) near += pool.choose(random).name == "near";
  CHECK(near > 500);
  for (std::size_t i = 0; i < 4 * Pool::most; ++i) pool.keep(named("far"), -50, random);
  near = 0;
  for (int i = 0; i < 1000; ++i) near += pool.choose(random).name == "near";
  CHECK(near > 100);  // if all were replaced alike: 500/1500 e^-4 of 1000, 6
}

TEST_CASE("Any scene can be chosen") {
  Pool pool;
  properties::Random random(1);
  pool.keep(named("far"), -50, random);
  pool.keep(named("near"), 3, random);
  int far = 0;
  for (int i = 0; i < 1000; ++i) far += pool.choose(random).name == "far";
  CHECK(far > 250);  // 3/8 of them
  CHECK(far < 500);
}

}  // namespace
}  // namespace touchstone::app
