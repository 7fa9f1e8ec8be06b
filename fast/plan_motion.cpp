#include <array>

#include "fast/counted.h"
#include "fast/plan.h"
#include "fast/simulation/prediction/pair_time_of_impact.h"

namespace touchstone::fast {
namespace {

using motion::Turning;
using simulation::BodyMotion;
using simulation::Kind;

void note(std::vector<Choice>& parts, std::size_t n, const std::string& one, const std::string& many,
          const std::string& what, const std::string& why) {
  if (n > 0) parts.push_back({what, counted(n, one, many) + why});
}

std::size_t pairs_of(std::size_t n) { return n * (n - (n > 0)) / 2; }

/// How many bodies and pairs of bodies there are of each kind.
struct Sorts {
  std::size_t bodies = 0, fixed = 0, stationary = 0;
  std::size_t balls = 0, fixed_balls = 0, blocks = 0;
  std::array<std::size_t, 3> turning{};  ///< of bodies that are neither fixed nor balls

  std::size_t fixed_pairs() const { return pairs_of(fixed); }
  std::size_t pairs() const { return pairs_of(bodies) - fixed_pairs(); }
  std::size_t closed() const { return pairs_of(balls) + balls * blocks - pairs_of(fixed_balls) - fixed_balls * blocks; }
};

Sorts sorts_of(const Scene& scene) {
  Sorts sorts;
  for (const Body& body : scene.bodies) {
    const BodyMotion body_motion(body, 0, scene.gravity);
    ++sorts.bodies;
    sorts.fixed += body_motion.fixed();
    sorts.stationary += is_stationary(body_motion);
    sorts.balls += body_motion.kind() == Kind::ball;
    sorts.fixed_balls += body_motion.kind() == Kind::ball && body_motion.fixed();
    sorts.blocks += body_motion.kind() == Kind::block;
    if (!body_motion.fixed() && body_motion.kind() != Kind::ball)
      ++sorts.turning[static_cast<std::size_t>(body_motion.model().turning)];
  }
  return sorts;
}

bool has_acceleration(const Scene& scene) { return !scene.gravity.isZero(0) || !scene.motion->forces.empty(); }

/// Contact mode handles contacts with micro-bounces within the envelope. Without gravity and applied forces there are
/// no micro-bounces, unless a body's own rotation presses it back (fast/simulation/response.h).
void plan_contact(const Scene& scene, const Sorts& sorts, Plan& plan) {
  const std::size_t may = has_acceleration(scene) ? sorts.pairs() : sorts.pairs() - sorts.closed();
  note(plan.used, may, "pair", "pairs", "contact mode",
       " may come to stay in contact: rest, slip and rolling in closed form on a face, else steps until they separate; "
       "each change is an event");
  note(plan.left_out, sorts.pairs() - may, "pair", "pairs", "contact mode",
       " of balls and blocks without a force that presses them together");
  const std::string whole = "each body follows one ballistic trajectory from event to event";
  plan.left_out.push_back({"time steps", may > 0 ? whole + ", except in contact" : whole});
}

}  // namespace

void plan_motion(const Scene& scene, Plan& plan) {
  const Sorts sorts = sorts_of(scene);
  const std::size_t closed = sorts.closed();
  const auto turning = [&](Turning how) { return sorts.turning[static_cast<std::size_t>(how)]; };
  note(plan.used, closed, "pair", "pairs", "times of impact in closed form",
       " of balls, or of a ball and a block that does not rotate");
  note(plan.used, sorts.pairs() - closed, "pair", "pairs", "conservative advancement",
       " of other shapes: steps on certified distances");
  note(plan.used, turning(Turning::tumbling), "body", "bodies", "Euler's equations",
       " with three different moments of inertia");
  plan_contact(scene, sorts, plan);
  note(plan.left_out, sorts.fixed_pairs(), "pair", "pairs", "pairs of fixed bodies", ": they never move");
  note(plan.left_out, sorts.pairs(), "pair", "pairs", "all pairs",
       " would be queried after every event; now only those whose swept boxes overlap");
  note(plan.left_out, sorts.stationary, "body", "bodies", "later frames",
       " that do not move: entered once into the broad phase, never the first of a query");
  note(plan.left_out, sorts.balls - sorts.fixed_balls, "ball", "balls", "orientation of balls",
       ": rotation does not change the space that a ball occupies");
  note(plan.left_out, turning(Turning::steady) + turning(Turning::precessing), "body", "bodies", "Euler's equations",
       " with two equal moments of inertia or more, turning in closed form");
}

}  // namespace touchstone::fast
