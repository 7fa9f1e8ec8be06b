#include "fast/simulation/island/island_step.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fast/simulation/prediction/length.h"
#include "model/limits.h"

namespace touchstone::fast::simulation {
namespace {

constexpr int most_halvings = 60;                // of a step, in the search for its end at a corner that comes down
constexpr int steps_per_halving = 4;             // of these one halves the interval; the others follow the clearance
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

/// How far the vertices of a step's contact pairs are above the separations down to which they may come (m).
struct ClearanceLeft {
  double least = never;   ///< a vertex that did not touch may come down to near/4; one that touched may sink by near/4
  double coming = never;  ///< of the vertices that did not touch
};

ClearanceLeft clearance_left(const std::vector<double>& before, const std::vector<double>& after, double near) {
  ClearanceLeft left;
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (before[i] > near) {
      left.coming = std::min(left.coming, after[i] - near / 4);
    } else {
      left.least = std::min(left.least, after[i] - (std::min(0.0, before[i]) - near / 4));
    }
  }
  left.least = std::min(left.least, left.coming);
  return left;
}

/// Where the clearance of the corner that comes down first vanishes, as a function of the length of the step: the root
/// of the parabola through the three latest lengths (Muller 1956), or of the line through the two latest.
class CornerSearch {
 public:
  struct Point {
    double h = 0, left = 0;  ///< s, m
  };

  CornerSearch(const Point& first, const Point& second) : before_(first), latest_(second) {}

  void add(const Point& point) {
    earlier_ = before_;
    has_three_ = true;
    before_ = std::exchange(latest_, point);
  }
  /// Not finite if there is none.
  double root() const {
    const double slope = (latest_.left - before_.left) / (latest_.h - before_.h);
    if (has_three_) {
      const double slope_before = (before_.left - earlier_.left) / (before_.h - earlier_.h);
      const double bend = (slope - slope_before) / (latest_.h - earlier_.h);
      const double at_latest = slope + bend * (latest_.h - before_.h);
      const double square = at_latest * at_latest - 4 * bend * latest_.left;
      if (square >= 0) return latest_.h - 2 * latest_.left / (at_latest + std::copysign(std::sqrt(square), at_latest));
    }
    return latest_.h - latest_.left / slope;
  }

 private:
  Point earlier_, before_, latest_;
  bool has_three_ = false;
};

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
  ClearanceLeft left = clearance_left_of(plan);
  if (left.least >= 0) return plan;
  const double enough = -near / 4;
  double low = 0;
  CornerSearch search({0, clearance_left(before, before, near).coming}, {plan.h, left.coming});
  for (int k = 0; k < most_halvings && left.least < enough && plan.h > least_share_of_step * h; ++k) {
    const double root = k % steps_per_halving == steps_per_halving - 1 ? low : search.root();
    StepPlan shorter = solve_step(graph, root > low && root < plan.h ? root : (low + plan.h) / 2, longest);
    const ClearanceLeft found = clearance_left_of(shorter);
    search.add({shorter.h, found.coming});
    if (found.least >= 0 && !(found.coming <= near / 4)) {
      low = shorter.h;
    } else {
      plan = std::move(shorter);
      left = found;
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
