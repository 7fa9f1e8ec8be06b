// A plan leaves out what the scene does not need, and this changes no pair.
#include "fast/plan.h"

#include <algorithm>
#include <iterator>

#include "fast/broad_phase.h"
#include "model/json.h"
#include "model/sequence.h"
#include "properties/scenes/domain.h"
#include "reference/bounds.h"
#include "reference/broad_phase.h"
#include "reference/validity.h"
#include "tests/catch.h"
#include "tests/fast/box_law.h"
#include "tests/reference/hard_pairs.h"

namespace touchstone::fast {
namespace {

using tests::body;
using tests::Dice;

/// Pairs that only one plan reports must be apart, by no more than the widening of the two boxes.
void check_free(const Scene& still, const PairSet& some, const PairSet& others) {
  PairSet differ;
  std::ranges::set_symmetric_difference(some, others, std::back_inserter(differ));
  if (differ.empty()) return;
  const std::vector<reference::ExactBox> exact = reference::bounds(still);
  for (const auto& [a, b] : differ) {
    const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
    const reference::Rational gap = reference::gap(exact[i], exact[j]);
    REQUIRE(gap.sign() > 0);
    REQUIRE(gap <= tests::widening(still.bodies[i]) + tests::widening(still.bodies[j]));
  }
}

/// Bodies keep their index: a body that is absent from a frame keeps its initial pose, and is in no pair.
Scene posed(const Scene& sequence, const Places& places) {
  Scene still = sequence;
  still.frames.clear();
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (places[i]) still.bodies[i].X_WB = *places[i];
  }
  return still;
}

void check_same_pairs(const Scene& sequence) {
  const PairHistory planned = pair_history(sequence, plan(sequence)),
                    full = pair_history(sequence, all_parts(sequence));
  const std::vector<Places> frames = places(sequence);
  REQUIRE(planned.size() == frames.size());
  for (std::size_t f = 0; f < frames.size(); ++f)
    check_free(posed(sequence, frames[f]), planned[f].pairs, full[f].pairs);
}

/// Whether every plan supports the sequence: no coordinate beyond 2^1000.
bool served(const Scene& sequence) {
  return std::ranges::all_of(sequence.frames, [](const SequenceFrame& frame) {
    return std::ranges::all_of(frame, [](const Placement& placement) {
      return !placement.X_WB || placement.X_WB->p_WB.cwiseAbs().maxCoeff() < 0x1p990;
    });
  });
}

TEST_CASE("plan: with parts left out the pairs are those with all parts, on every family of films") {
  int sequences = 0;
  for (const properties::Family& family : properties::families()) {
    for (std::uint64_t index = 0; index < 60; ++index) {
      const Scene sequence = properties::draw(family, 5, index);
      if (!is_sequence(sequence)) break;
      if (!served(sequence)) continue;
      check_same_pairs(sequence);
      ++sequences;
    }
  }
  CHECK(sequences > 400);
}

Scene swarm(int bodies, int vertices, int frames) {
  Dice dice(41);
  Scene sequence;
  for (int i = 0; i < bodies; ++i) sequence.bodies.push_back(body(tests::round_hull(dice, vertices)));
  for (int f = 0; f < frames; ++f) {
    SequenceFrame frame;
    for (int i = 0; i < bodies; ++i) {
      const Vec3 p = 3 * dice.in_cube();
      frame.push_back({i, Pose{p, tests::integer_quaternion(dice)}});
    }
    sequence.frames.push_back(frame);
  }
  return sequence;
}

TEST_CASE("plan: the same on a swarm of many vertices, where all parts are at work") {
  const Scene sequence = swarm(40, 40, 6);
  const Plan chosen = plan(sequence);
  CHECK(chosen.strategy == "wrapped_grid");
  CHECK(std::ranges::count(chosen.bounds, BoundKind::climb) == 40);
  check_same_pairs(sequence);
  check_same_pairs(swarm(20, 10, 6));
}

bool has(const std::vector<Choice>& choices, const std::string& what) {
  return std::ranges::any_of(choices, [&](const Choice& choice) { return choice.what == what; });
}

std::string reason(const std::vector<Choice>& choices, const std::string& what) {
  return std::ranges::find(choices, what, &Choice::what)->why;
}

TEST_CASE("plan: counts the pairs") {
  Scene scene;
  for (int i = 0; i < 3; ++i) scene.bodies.emplace_back().shape = Sphere{1};
  CHECK(reason(plan(scene).used, "all pairs").starts_with("3 pairs at most"));
  for (int i = 3; i < 100; ++i) scene.bodies.emplace_back().shape = Sphere{1};
  CHECK(reason(plan(scene).left_out, "all pairs").starts_with("4950 pairs would be compared"));
}

TEST_CASE("plan: says of each named scene what it needs") {
  struct Expected {
    std::string scene, strategy;
    std::vector<std::string> used, left_out;
  };
  const std::string climbing = "hill climbing on six extremal vertices", memory = "memory between frames";
  const std::vector<Expected> named = {
      {"alone", "all_pairs", {"boxes in closed form"}, {"every strategy", memory}},
      {"two_boxes", "all_pairs", {"all pairs", "boxes in closed form"}, {"wrapped grid", "vertices", memory}},
      {"marbles", "wrapped_grid", {"wrapped grid", "boxes in closed form"}, {"all pairs", "vertices", memory}},
      {"dice", "all_pairs", {"all pairs", memory}, {"vertices"}},
      {"gems", "all_pairs", {"a scan of all vertices", memory}, {"hill climbing", "wrapped grid"}},
      {"ball_of_many_faces", "all_pairs", {climbing, memory}, {"wrapped grid"}},
      {"swarm", "wrapped_grid", {"wrapped grid", "a scan of all vertices", memory}, {"hill climbing", "all pairs"}},
      {"statues", "wrapped_grid", {"wrapped grid", memory}, {"later frames", "hill climbing"}},
  };
  for (const Expected& expected : named) {
    CAPTURE(expected.scene);
    const Scene scene =
        reference::completed(read_scene(TOUCHSTONE_SOURCE "/docs/scenes/broad_phase/" + expected.scene + ".json"));
    const Plan chosen = plan(scene);
    CHECK(chosen.strategy == expected.strategy);
    for (const std::string& what : expected.used) CHECK(has(chosen.used, what));
    for (const std::string& what : expected.left_out) CHECK(has(chosen.left_out, what));
    if (is_sequence(scene)) check_same_pairs(scene);
  }
}

}  // namespace
}  // namespace touchstone::fast
