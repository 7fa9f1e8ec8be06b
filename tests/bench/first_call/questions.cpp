#include "tests/bench/first_call/questions.h"

#include <algorithm>
#include <cmath>

#include "fast/bounds.h"
#include "fast/broad_phase.h"
#include "fast/constraint.h"
#include "fast/distance.h"
#include "fast/impulse.h"
#include "fast/mass.h"
#include "fast/penetration.h"
#include "fast/pixel.h"
#include "fast/plan.h"
#include "fast/simulation.h"
#include "fast/time_of_impact.h"
#include "properties/scenes/domain.h"
#include "reference/bounds.h"
#include "reference/broad_phase.h"
#include "reference/constraint.h"
#include "reference/distance.h"
#include "reference/impulse.h"
#include "reference/mass.h"
#include "reference/penetration.h"
#include "reference/pixel.h"
#include "reference/simulation.h"
#include "reference/time_of_impact.h"
#include "tests/reference/moving_scenes.h"

namespace touchstone::bench {
namespace {

constexpr std::uint64_t seed = 1;

/// Answers that are complete whenever the function returns.
template <class Answer>
std::function<bool(const Scene&)> whole(Answer answer) {
  return [answer](const Scene& scene) {
    static_cast<void>(answer(scene));
    return true;
  };
}

/// A simulation that stops early answers less of its question.
template <class Simulate>
std::function<bool(const Scene&)> to_the_end(Simulate simulate) {
  return [simulate](const Scene& scene) { return !simulate(scene).complete_until; };
}

using tests::Dice;

Scene hulls(Dice& dice, int vertices, double apart) {
  const Vec3 away = apart * dice.in_cube().normalized();
  return tests::pair_of({{tests::round_hull(dice, vertices), away, tests::random_quaternion(dice)},
                         {tests::round_hull(dice, vertices), Vec3::Zero(), tests::random_quaternion(dice)}});
}

/// Unit boxes, one for each 8 m³.
Scene crowd(Dice& dice, int bodies) {
  Scene scene;
  const double half = std::cbrt(bodies);
  for (int i = 0; i < bodies; ++i) {
    const Vec3 p = half * dice.in_cube();
    scene.bodies.push_back(tests::body(Box{Vec3(0.5, 0.5, 0.5)}, p, tests::random_quaternion(dice)));
  }
  return scene;
}

/// Three frames in which all boxes move by a tenth of their side.
Scene moving_crowd(Dice& dice, int bodies) {
  Scene scene = crowd(dice, bodies);
  std::vector<Pose> poses;
  for (const Body& body : scene.bodies) poses.push_back(body.X_WB);
  for (int frame = 0; frame < 3; ++frame) {
    SequenceFrame placements;
    for (int i = 0; i < bodies; ++i) {
      Pose& pose = poses[static_cast<std::size_t>(i)];
      pose.p_WB += 0.1 * dice.in_cube();
      placements.push_back({i, pose});
    }
    scene.frames.push_back(std::move(placements));
  }
  return scene;
}

Scene tumbling(Scene scene) {
  for (Body& body : scene.bodies) body.mass = Density{};
  return scene;
}

template <class Make>
Questions made(const std::string& name, int count, Make make) {
  Questions some{name, {}};
  Dice dice(seed);
  for (int i = 0; i < count; ++i) some.scenes.push_back(make(dice));
  return some;
}

void add_hulls(std::vector<Questions>& all, const std::string& query, int count) {
  for (const int n : {8, 20, 50, 200}) {
    const std::string of = "hulls of " + std::to_string(n) + " vertices";
    if (query == "time_of_impact") {
      if (n == 200) continue;  // the reference takes seconds
      all.push_back(made(of + ": screws", count, [n](Dice& dice) { return tests::ballistic_pair(dice, n); }));
      all.push_back(
          made(of + ": tumbling", count, [n](Dice& dice) { return tumbling(tests::ballistic_pair(dice, n)); }));
      continue;
    }
    all.push_back(made(of + ": apart", count, [n](Dice& dice) { return hulls(dice, n, 2.5); }));
    if (query == "distance" || query == "penetration")
      all.push_back(made(of + ": overlapping", count, [n](Dice& dice) { return hulls(dice, n, 0.8); }));
  }
}

void add_crowds(std::vector<Questions>& all, const std::string& query, int count) {
  for (const int n : {16, 100, 1000}) {
    const std::string of = std::to_string(n) + " boxes";
    const bool moves = query == "pair_history";
    all.push_back(made(of, count, [n, moves](Dice& dice) { return moves ? moving_crowd(dice, n) : crowd(dice, n); }));
  }
}

bool is_one_of(const std::string& query, std::initializer_list<const char*> names) {
  return std::ranges::find(names, query) != names.end();
}

}  // namespace

const std::vector<Asked>& asked_queries() {
  static const std::vector<Asked> all{
      {"mass", whole([](const Scene& s) { return fast::mass(s); }),
       whole([](const Scene& s) { return reference::mass(s); })},
      {"bounds", whole([](const Scene& s) { return fast::bounds(s); }),
       whole([](const Scene& s) { return reference::bounds(s); })},
      {"broad_phase", whole([](const Scene& s) { return fast::broad_phase(s); }),
       whole([](const Scene& s) { return reference::broad_phase(s); })},
      {"pair_history", whole([](const Scene& s) { return fast::pair_history(s, fast::plan(s)); }),
       whole([](const Scene& s) { return reference::pair_history(reference::sequence_bounds(s)); })},
      {"distance", whole([](const Scene& s) { return fast::distance(s); }),
       whole([](const Scene& s) { return reference::distance(s); })},
      {"penetration", whole([](const Scene& s) { return fast::penetration_depth(s); }),
       whole([](const Scene& s) { return reference::penetration(s); })},
      {"pixel", whole([](const Scene& s) { return fast::pixels(s); }),
       whole([](const Scene& s) { return reference::pixel(s); })},
      {"impulse", whole([](const Scene& s) { return fast::impulse_of(s); }),
       whole([](const Scene& s) { return reference::impulse(s, reference::Digits::some); })},
      {"time_of_impact", whole([](const Scene& s) { return fast::time_of_impact_of(s); }),
       whole([](const Scene& s) { return reference::time_of_impact(s); })},
      {"simulation", to_the_end([](const Scene& s) { return fast::simulate(s).trajectory; }),
       to_the_end([](const Scene& s) { return reference::simulation(s); })},
      {"constraint", to_the_end([](const Scene& s) { return fast::constrained(s); }),
       whole([](const Scene& s) { return reference::constraint(s); })}};
  return all;
}

std::vector<Questions> questions(const std::string& query, int count) {
  std::vector<Questions> all;
  const bool moves = query == "pair_history";
  for (const properties::Family* family :
       properties::for_query(properties::families(), moves ? "broad_phase" : query)) {
    Questions some{family->id, {}};
    for (int i = 0; i < count; ++i) {
      Scene scene = properties::draw(*family, seed, static_cast<std::uint64_t>(i));
      if (moves == scene.frames.empty() && is_one_of(query, {"pair_history", "broad_phase"})) continue;
      some.scenes.push_back(std::move(scene));
    }
    if (!some.scenes.empty()) all.push_back(std::move(some));
  }
  if (is_one_of(query, {"mass", "bounds", "distance", "penetration", "time_of_impact"})) add_hulls(all, query, count);
  if (is_one_of(query, {"bounds", "broad_phase", "pair_history"})) add_crowds(all, query, count);
  return all;
}

}  // namespace touchstone::bench
