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

}  // namespace

void plan_motion(const Scene& scene, Plan& plan) {
  const Sorts sorts = sorts_of(scene);
  const std::size_t closed = sorts.closed();
  const auto turning = [&](Turning how) { return sorts.turning[static_cast<std::size_t>(how)]; };
  note(plan.used, closed, "pair", "pairs", "meetings in closed form",
       " of balls, or of a ball and a block that stands");
  note(plan.used, sorts.pairs() - closed, "pair", "pairs", "conservative advancement",
       " of other shapes: steps on certified distances");
  note(plan.used, turning(Turning::tumbling), "body", "bodies", "Euler's equations",
       " with three different moments of inertia");
  plan.left_out.push_back({"time steps", "each body flies in one piece from event to event"});
  note(plan.left_out, sorts.fixed_pairs(), "pair", "pairs", "pairs of fixed bodies",
       ": nothing becomes of their meeting");
  note(plan.left_out, sorts.pairs(), "pair", "pairs", "all pairs",
       " would be asked after every event: only those whose boxes over a frame meet are");
  note(plan.left_out, sorts.still, "body", "bodies", "later frames",
       " that stand: filed once, never asked first again");
  note(plan.left_out, sorts.balls - sorts.fixed_balls, "ball", "balls", "attitudes of balls",
       ": whatever they spin, no point of the space that they fill moves");
  note(plan.left_out, turning(Turning::steady) + turning(Turning::precessing), "body", "bodies", "Euler's equations",
       " with two equal moments of inertia or more: they turn in closed form");
}

}  // namespace touchstone::fast
