// Which words an execution leaves, and how near it is to a failure.
#include "app/fuzz/signals.h"

#include "tests/catch.h"

namespace touchstone::app {
namespace {

oracle::Finding finding(oracle::Outcome outcome, double error, double allowed) {
  oracle::Finding made;
  made.outcome = outcome;
  made.error = error;
  made.allowed = allowed;
  made.unit = "ulps of the scene's scale";
  return made;
}

TEST_CASE("An error is a power of two of what is allowed") {
  Signals signals;
  signals.add_finding(properties::find("distance.value"), finding(oracle::Outcome::holds, 3, 16));
  CHECK(signals.words().contains("distance.value holds 2^-3"));
  CHECK(signals.nearness() == Approx(std::log2(3.0 / 16)));
  signals.add_finding(properties::find("distance.verdict"), finding(oracle::Outcome::holds, 0, 16));
  CHECK(signals.nearness() == Approx(std::log2(3.0 / 16)));
}

TEST_CASE("A failure is nearer than anything that holds, and nearer the larger its error") {
  Signals slight, great;
  oracle::Finding wrong = finding(oracle::Outcome::fails, 32, 16);
  wrong.defect = oracle::Defect::too_far;
  slight.add_finding(properties::find("distance.value"), wrong);
  wrong.error = 1e9;
  great.add_finding(properties::find("distance.value"), wrong);
  CHECK(slight.words().contains("distance.value fails too_far 2^1"));
  CHECK(slight.nearness() == 1);
  CHECK(great.nearness() > slight.nearness());
  Signals broken;
  oracle::Finding crash;
  crash.outcome = oracle::Outcome::breaks;
  crash.defect = oracle::Defect::crashed;
  broken.add_finding(properties::find("distance.value"), crash);
  CHECK(broken.nearness() == 0);
}

TEST_CASE("Each place of fast that was reached is a word") {
  Signals signals;
  fast::MarkCounts before{}, after{};
  after[3] = 5;
  signals.add_marks(before, after);
  CHECK(signals.words() == std::set<std::string>{"mark 3 2^2"});
}

TEST_CASE("A pair that nearly touches is nearer to a failure than one that does not") {
  const auto signals_of = [](double gap) {
    Scene scene;
    for (const double x : {0.0, 2 + gap}) {
      Body body;
      body.shape = Box{Vec3(1, 1, 1)};
      body.X_WB.p_WB.x() = x;
      scene.bodies.push_back(body);
    }
    Signals signals;
    signals.add_scene(scene, "distance");
    return signals;
  };
  CHECK(signals_of(0x1p-40).nearness() > signals_of(1).nearness());
  CHECK(signals_of(0x1p-40).words().contains("margin 2^-42"));
  CHECK(signals_of(0).words().contains("margin 2^-60"));
}

}  // namespace
}  // namespace touchstone::app
