#include "fast/plan.h"

#include <algorithm>
#include <variant>

#include "fast/broad_phase.h"
#include "fast/counted.h"
#include "model/sequence.h"

namespace touchstone::fast {
namespace {

/// From this many vertices on, climbing costs less than scanning all of them (measured, docs/measured/plan.md:
/// 20 cost the same).
constexpr std::size_t worth_climbing = 24;

std::size_t most_vertices(const Sphere&) { return 0; }
std::size_t most_vertices(const Box&) { return 0; }
std::size_t most_vertices(const Polytope& polytope) { return polytope.vertices.size(); }
std::size_t most_vertices(const Compound& compound) {
  std::size_t most = 0;
  for (const touchstone::Part& part : compound.parts) {
    most = std::max(most, std::visit([](const auto& shape) { return most_vertices(shape); }, part.shape));
  }
  return most;
}
std::size_t most_vertices(const Body& body) {
  return std::visit([](const auto& shape) { return most_vertices(shape); }, body.shape);
}

/// How often the sequence sets each body's pose; once each in a single snapshot.
std::vector<int> times_placed(const Scene& scene) {
  std::vector<int> times(scene.bodies.size(), is_sequence(scene) ? 0 : 1);
  for (const SequenceFrame& frame : scene.frames) {
    for (const Placement& placement : frame) {
      if (placement.X_WB) ++times[static_cast<std::size_t>(placement.body)];
    }
  }
  return times;
}

/// Adds a choice with the number of bodies it concerns, if there are any.
void note(std::vector<Choice>& parts, std::size_t bodies, const std::string& what, const std::string& why) {
  if (bodies > 0) parts.push_back({what, counted(bodies, "body ", "bodies ") + why});
}

void choose_strategy(const Scene& scene, Plan& plan) {
  const std::size_t n = scene.bodies.size();
  if (n < 2) {
    plan.strategy = "all_pairs";
    plan.left_out.push_back({"every strategy", "there is no pair: " + counted(n, "body", "bodies")});
  } else if (n <= few_bodies) {
    plan.strategy = "all_pairs";
    plan.used.push_back({"all pairs", counted(n * (n - 1) / 2, "pair", "pairs") +
                                          " at most: comparing them costs less than keeping a grid (up to " +
                                          std::to_string(few_bodies) + " bodies)"});
    plan.left_out.push_back({"wrapped grid", counted(n, "body", "bodies") + " are too few for a grid to be cheaper"});
  } else {
    plan.strategy = "wrapped_grid";
    plan.used.push_back(
        {"wrapped grid", counted(n, "body", "bodies") + ", one cell each; the cost grows with n, not with its square"});
    plan.left_out.push_back(
        {"all pairs", counted(n * (n - 1) / 2, "pair", "pairs") + " would be compared in every frame"});
  }
}

void choose_bounds(const Scene& scene, Plan& plan) {
  const std::vector<int> times = times_placed(scene);
  std::size_t plain = 0, small = 0, once = 0, climbing = 0;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const std::size_t vertices = most_vertices(scene.bodies[i]);
    const bool climbs = times[i] > 1 && vertices >= worth_climbing;
    plan.bounds.push_back(vertices == 0 ? BoundKind::closed_form : climbs ? BoundKind::climb : BoundKind::scan);
    ++(vertices == 0 ? plain : climbs ? climbing : times[i] > 1 ? small : once);
  }
  const std::string least = std::to_string(worth_climbing);
  note(plan.used, plain, "boxes in closed form", "without vertices");
  note(plan.used, small + once, "a scan of all vertices", "with fewer than " + least + " vertices or placed only once");
  note(plan.used, climbing, "hill climbing on six extremal vertices",
       "with " + least + " vertices or more, placed again and again");
  note(plan.left_out, plain, "vertices", "made of spheres and boxes, whose extent is a formula");
  note(plan.left_out, small, "hill climbing",
       "with fewer than " + least + " vertices: scanning them all costs no more");
  note(plan.left_out, once, "hill climbing", "placed only once: no earlier frame to start from");
}

void choose_memory(const Scene& scene, Plan& plan) {
  if (scene.frames.size() < 2) {
    plan.left_out.push_back(
        {"memory between frames", is_sequence(scene) ? "the sequence has one frame" : "the scene has no frames"});
    return;
  }
  const std::vector<int> times = times_placed(scene);
  const auto moving = static_cast<std::size_t>(std::ranges::count_if(times, [](int t) { return t > 1; }));
  plan.used.push_back({"memory between frames", counted(scene.frames.size(), "frame", "frames") +
                                                    ": pairs are kept, and only bodies that moved are checked"});
  note(plan.left_out, times.size() - moving, "later frames",
       "never placed again: entered once into the broad phase, never queried again");
}

}  // namespace

Plan plan(const Scene& scene) {
  Plan plan;
  choose_strategy(scene, plan);
  choose_bounds(scene, plan);
  choose_memory(scene, plan);
  return plan;
}

Plan all_parts(const Scene& scene) {
  Plan plan;
  plan.strategy = "wrapped_grid";
  for (const Body& body : scene.bodies) {
    plan.bounds.push_back(most_vertices(body) == 0 ? BoundKind::closed_form : BoundKind::climb);
  }
  return plan;
}

}  // namespace touchstone::fast
