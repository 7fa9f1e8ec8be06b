#include <array>

#include "fast/counted.h"
#include "fast/plan.h"
#include "fast/simulation/meeting.h"

namespace touchstone::fast {
namespace {

using motion::Turning;
using world::Kind;
using world::Mover;

void note(std::vector<Choice>& parts, std::size_t n, const std::string& one, const std::string& many,
          const std::string& what, const std::string& why) {
  if (n > 0) parts.push_back({what, counted(n, one, many) + why});
}

std::size_t pairs_of(std::size_t n) { return n * (n - (n > 0)) / 2; }

/// How many bodies there are of each sort; pairs follow.
struct Sorts {
  std::size_t bodies = 0, fixed = 0, still = 0;
  std::size_t balls = 0, fixed_balls = 0, blocks = 0;
  std::array<std::size_t, 3> turning{};  ///< of bodies that are neither fixed nor balls

  std::size_t fixed_pairs() const { return pairs_of(fixed); }
  std::size_t pairs() const { return pairs_of(bodies) - fixed_pairs(); }
  std::size_t closed() const { return pairs_of(balls) + balls * blocks - pairs_of(fixed_balls) - fixed_balls * blocks; }
};

Sorts sorts_of(const Scene& scene) {
  Sorts sorts;
  for (const Body& body : scene.bodies) {
    const Mover mover(body, 0, scene.gravity);
    ++sorts.bodies;
    sorts.fixed += mover.fixed();
    sorts.still += mover.still();
    sorts.balls += mover.kind() == Kind::ball;
    sorts.fixed_balls += mover.kind() == Kind::ball && mover.fixed();
    sorts.blocks += mover.kind() == Kind::block;
    if (!mover.fixed() && mover.kind() != Kind::ball) ++sorts.turning[static_cast<std::size_t>(mover.flyer().turning)];
  }
  return sorts;
}

bool pulls(const Scene& scene) { return !scene.gravity.isZero(0) || !scene.flight->pushes.empty(); }

/// Contact mode is for what meets no faster than a hop within the envelope; where nothing pulls there is no hop, unless
/// a body's own turning would press it back (fast/simulation/loop_group.cpp).
void plan_contact(const Scene& scene, const Sorts& sorts, Plan& plan) {
  const std::size_t may = pulls(scene) ? sorts.pairs() : sorts.pairs() - sorts.closed();
  note(
      plan.used, may, "pair", "pairs", "contact mode",
      " may come to stay in contact: rest, slip and rolling in closed form on a face, else steps until they part; each "
      "hand-over is an event");
  note(plan.left_out, sorts.pairs() - may, "pair", "pairs", "contact mode",
       " of balls and blocks that nothing presses together");
  const std::string whole = "each body flies in one piece from event to event";
  plan.left_out.push_back({"time steps", may > 0 ? whole + ", but in contact" : whole});
}

}  // namespace

void plan_motion(const Scene& scene, Plan& plan) {
  const Sorts sorts = sorts_of(scene);
  const std::size_t closed = sorts.closed();
  const auto turning = [&](Turning how) { return sorts.turning[static_cast<std::size_t>(how)]; };
  note(plan.used, closed, "pair", "pairs", "meetings in closed form",
       " of balls, or of a ball and a block that does not turn");
  note(plan.used, sorts.pairs() - closed, "pair", "pairs", "conservative advancement",
       " of other shapes: steps on certified distances");
  note(plan.used, turning(Turning::tumbling), "body", "bodies", "Euler's equations",
       " with three different moments of inertia");
  plan_contact(scene, sorts, plan);
  note(plan.left_out, sorts.fixed_pairs(), "pair", "pairs", "pairs of fixed bodies", ": nothing becomes of a meeting");
  note(plan.left_out, sorts.pairs(), "pair", "pairs", "all pairs",
       " would be asked after every event; now only where boxes over a frame meet");
  note(plan.left_out, sorts.still, "body", "bodies", "later frames",
       " standing still: filed once, never asked first again");
  note(plan.left_out, sorts.balls - sorts.fixed_balls, "ball", "balls", "attitudes of balls",
       ": whatever the spin, no point of the space that a ball fills moves");
  note(plan.left_out, turning(Turning::steady) + turning(Turning::precessing), "body", "bodies", "Euler's equations",
       " with two equal moments of inertia or more, turning in closed form");
}

}  // namespace touchstone::fast
