#include "fast/simulation/island/island_rest.h"

#include "fast/simulation/island/island_step.h"
#include "fast/simulation/prediction/length.h"

namespace touchstone::fast::simulation {
namespace {

constexpr double balance_tolerance = 0x1p-30;  // greatest unbalanced acceleration, relative to the applied one
constexpr double left_over = 0x1p-20;          // of the speed at rest: what a frictionless contact may leave

/// Those that contacts with friction connect to a fixed body.
std::vector<bool> braked_bodies(const ContactGraph& graph, const std::vector<contact::ContactConstraint>& contacts) {
  std::vector<bool> braked;
  for (const IslandBody& island_body : graph.bodies()) braked.push_back(island_body.fixed());
  for (bool found = true; found;) {
    found = false;
    for (const contact::ContactConstraint& at : contacts) {
      if (!(at.friction > 0) || braked[at.a] == braked[at.b]) continue;
      braked[at.a] = braked[at.b] = found = true;
    }
  }
  return braked;
}

}  // namespace

void remove_approach(ContactGraph& graph) {
  std::vector<contact::StepBody> all = step_bodies(graph);
  contact::land(all, constraints(graph));
  for (std::size_t i = 0; i < all.size(); ++i) graph.body(i).step_body.state = all[i].state;
}

bool rest_test(ContactGraph& graph, double rest_speed) {
  std::vector<contact::ContactConstraint> contact_points = constraints(graph);
  const std::vector<bool> braked = braked_bodies(graph, contact_points);
  bool pulled = false;
  for (std::size_t i = 0; i < graph.bodies().size(); ++i) {
    const IslandBody& island_body = graph.bodies()[i];
    const Velocity& V = island_body.state().velocity;
    const double speed = length(V.v_WBcm) + length(V.w_WB) * island_body.body->radius();
    if (speed > (island_body.fixed() ? 0 : braked[i] ? rest_speed : left_over * rest_speed)) return false;
    pulled = pulled || (!island_body.fixed() && !island_body.step_body.acceleration.isZero(0));
  }
  if (pulled && !(contact::unbalanced(step_bodies(graph), contact_points) <= balance_tolerance)) return false;
  for (std::size_t i = 0; i < graph.bodies().size(); ++i) graph.body(i).step_body.state.velocity = {};
  return true;
}

double energy(const ContactGraph& graph) {
  double sum = 0;
  for (const IslandBody& island_body : graph.bodies()) {
    if (island_body.fixed()) continue;
    const contact::StepBody& body = island_body.step_body;
    sum += body.kinetic_energy() - body.model->mass * body.acceleration.dot(body.transform().centre);
  }
  return sum;
}

}  // namespace touchstone::fast::simulation
