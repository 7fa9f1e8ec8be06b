#include "fast/simulation/island/island_step.h"

#include <algorithm>
#include <cmath>

#include "fast/simulation/prediction/length.h"
#include "model/limits.h"

namespace touchstone::fast::simulation {
namespace {

constexpr int most_halvings = 60;                // of a step, in the search for its end at a corner that comes down
constexpr double least_share_of_step = 0x1p-20;  // of a step: a step that short is taken even if corners overlap
constexpr double step_tolerance = 0x1p-10;       // accuracy of a step, relative to the distance that counts as touching
// Of distances from the origin. A gap is n·(p − q) of two points R x + c: less than 16 roundings of each, twice for the
// change of the gap.
constexpr double position_rounding = 0x1p-46;

/// The separations of all vertices of all contact pairs (m), each along the normal of its pair.
std::vector<double> clearances(const ContactGraph& graph, const std::vector<State>& states) {
  std::vector<double> all;
  for (const ContactPair& contact_pair : graph.contact_pairs()) {
    const std::size_t a = graph.index(contact_pair.a), b = graph.index(contact_pair.b);
    const std::vector<double> some =
        clearances(contact_pair, graph.bodies()[a], states[a], graph.bodies()[b], states[b], graph.near());
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

/// The least distance of a vertex above its allowed separation (m). A vertex that did not touch may come down to
/// near/4; one that touched may sink by near/4.
double clearance_left(const std::vector<double>& before, const std::vector<double>& after, double near) {
  double least = never;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const double lowest = before[i] > near ? near / 4 : std::min(0.0, before[i]) - near / 4;
    least = std::min(least, after[i] - lowest);
  }
  return least;
}

std::vector<State> states_of(const ContactGraph& graph) {
  std::vector<State> states;
  for (const IslandBody& island_body : graph.bodies()) states.push_back(island_body.state());
  return states;
}

}  // namespace

std::vector<contact::StepBody> step_bodies(const ContactGraph& graph) {
  std::vector<contact::StepBody> all;
  for (const IslandBody& island_body : graph.bodies()) all.push_back(island_body.step_body);
  return all;
}

std::vector<contact::ContactConstraint> constraints(const ContactGraph& graph) {
  std::vector<contact::ContactConstraint> all;
  for (const ContactPair& contact_pair : graph.contact_pairs()) {
    const std::size_t a = graph.index(contact_pair.a), b = graph.index(contact_pair.b);
    const double friction = coefficients(*graph.bodies()[a].body, *graph.bodies()[b].body, Law::poisson).friction;
    for (const contact::ContactPoint& contact_point : contact_pair.contact_points)
      all.push_back({a, b, contact_point, contact_pair.nhat_BA_W, friction});
  }
  return all;
}

double step_length(const ContactGraph& graph, double steps, double most) {
  double rate = 0;
  for (const IslandBody& island_body : graph.bodies()) {
    if (island_body.fixed()) continue;
    const Velocity& V = island_body.state().velocity;
    const double size = touchstone::size(island_body.body->body().shape);
    rate = std::max(
        rate, length(V.w_WB) + length(V.v_WBcm) / size + std::sqrt(length(island_body.step_body.acceleration) / size));
  }
  return std::min(most, 1 / (steps * rate));
}

double accuracy(const ContactGraph& graph) { return step_tolerance * graph.near(); }

double residual_bound(const ContactGraph& graph, double steps) {
  double least = never, farthest = 0;
  for (const IslandBody& island_body : graph.bodies()) {
    farthest = std::max(farthest, length(island_body.step_body.transform().centre) + island_body.body->radius());
    if (!island_body.fixed()) least = std::min(least, touchstone::size(island_body.body->body().shape));
  }
  return std::max(graph.near(), least / (steps * steps * steps)) + position_rounding * farthest;
}

StepPlan solve_step(const ContactGraph& graph, double h, double longest) {
  StepPlan plan{h, {}, constraints(graph)};
  plan.stepped = step(step_bodies(graph), plan.constraints, h, accuracy(graph), graph.near() / std::max(h, longest));
  return plan;
}

StepPlan plan_step(const ContactGraph& graph, double h, double longest) {
  const double near = graph.near();
  const std::vector<double> before = clearances(graph, states_of(graph));
  const auto clearance_left_of = [&](const StepPlan& plan) {
    return clearance_left(before, clearances(graph, plan.stepped.after), near);
  };
  StepPlan plan = solve_step(graph, h, longest);
  const double enough = -near / 4;
  double low = 0, over = clearance_left_of(plan), over_later = over, later = h;
  if (over >= 0) return plan;
  for (int k = 0; k < most_halvings && over < enough && plan.h > least_share_of_step * h; ++k) {
    const double high = plan.h, secant = high - (over - enough / 2) * (later - high) / (over_later - over);
    StepPlan shorter = solve_step(graph, secant > low && secant < high ? secant : (low + high) / 2, longest);
    const double found = clearance_left_of(shorter);
    if (found >= 0) {
      low = shorter.h;
    } else {
      later = high, over_later = over;
      plan = std::move(shorter), over = found;
    }
  }
  return plan;
}

double deepest(const ContactGraph& graph, const StepPlan& plan) {
  return std::max(0.0, -std::ranges::min(clearances(graph, plan.stepped.after)));
}

double deviation(const ContactGraph& graph, const StepPlan& plan) {
  const double h = plan.h;
  double most = 0;
  for (std::size_t i = 0; i < graph.bodies().size(); ++i) {
    const IslandBody& island_body = graph.bodies()[i];
    if (island_body.fixed()) continue;
    const Velocity &before = island_body.state().velocity, &after = plan.stepped.after[i].velocity;
    const double turn = h * length(plan.stepped.mean[i].w);
    const double spun = h * length(after.w_WB - before.w_WB) / 4 + turn * turn * turn / 8;
    const double bent = h * length(after.v_WBcm - before.v_WBcm) / 4;
    most = std::max(most, spun * (island_body.body->kind() == Kind::ball ? 0 : island_body.body->radius()) + bent);
  }
  return most;
}

}  // namespace touchstone::fast::simulation
