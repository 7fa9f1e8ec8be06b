#include "fast/simulation/island/island_step.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "fast/simulation/prediction/length.h"
#include "model/limits.h"

namespace touchstone::fast::simulation {
namespace {

constexpr int most_halvings = 60;            // of a step, in the search for its end at a corner that comes down
constexpr int steps_per_halving = 4;         // of these one halves the interval; the others follow the clearance
constexpr double share_of_moment = 0x1p-10;  // of a step: so long a corner keeps the rate at its start
constexpr double early_share = 0x1p-3;       // of a step: where corners hardly above others are looked at too
constexpr double hardly_above = 64;          // times the distance that counts as touching
constexpr int cuts_at_end_of_contact = 14;   // halvings of a step: it ends less than h/2¹⁴ after the contact does
constexpr int most_slip_cuts = 8;            // of a step, in the search for the end of slip
constexpr int most_friction_cuts = 10;       // of a step, in the search for the end of friction: to h/100
constexpr double least_share_of_force = 1. / 3;  // of a contact's last force: it falls to 0 in a step, if linearly
constexpr double golden = 0.61803398874989485;
constexpr double share_of_rebound = 0x1p-4;  // the speed at which a body leaves what counts as touching and comes back
constexpr int few_bodies = 2;                // that move: all of their slip is followed to its end
constexpr double lost = 16;                  // times the distance that counts as touching: bodies farther apart
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

/// Their rates at the current states (m/s).
std::vector<double> clearance_rates(const ContactGraph& graph) {
  std::vector<double> all;
  for (const ContactPair& contact_pair : graph.contact_pairs()) {
    const std::size_t a = graph.index(contact_pair.a), b = graph.index(contact_pair.b);
    const std::vector<double> some = clearance_rates(contact_pair, graph.bodies()[a], graph.bodies()[b]);
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

/// Whether a vertex that did not touch may come down within h, unless contact forces push it.
bool may_come_down(const ContactGraph& graph, const std::vector<double>& before, double h) {
  double speed = 0;
  for (const IslandBody& island_body : graph.bodies()) speed = std::max(speed, speed_bound(island_body, h));
  const double near = graph.near(), most = near + 2 * h * speed;
  return std::ranges::any_of(before, [=](double clearance) { return clearance > near && clearance <= most; });
}

/// The clearances at the end of a step of h (s, m).
struct Sample {
  double h = 0;
  std::vector<double> clearances;
};

/// A corner's clearance (m) between two lengths of the step (s): at_low + slope x + bend x², x = h − low.
struct ClearanceCurve {
  double low = 0, width = 0, at_low = 0, slope = 0, bend = 0;

  /// Of all in between; infinity if it has no minimum there.
  double least() const {
    const double at = -slope / (2 * bend);
    return bend > 0 && at > 0 && at < width ? at_low + slope * at / 2 : infinity;
  }
  /// Where it vanishes in between, for the first time.
  double root() const {
    const double q = -(slope + std::copysign(std::sqrt(slope * slope - 4 * bend * at_low), slope)) / 2;
    const double root = at_low / q;
    return low + (root > 0 && root < width ? root : q / bend);
  }
};

/// Where the first corner comes down that did not touch, as a function of the length of the step: the root of a
/// parabola (Muller 1956). Each corner has one of its own, since the least of their clearances has a kink wherever
/// another corner becomes the lowest.
class CornerSearch {
 public:
  CornerSearch(Sample start, const std::vector<double>& rates, Sample high, double near)
      : low_(std::move(start)), third_(low_), high_(std::move(high)), near_(near) {
    third_.h = share_of_moment * high_.h;
    for (std::size_t i = 0; i < rates.size(); ++i) {
      if (low_.clearances[i] > near) coming_.push_back(i);
      third_.clearances[i] += third_.h * rates[i];
    }
  }

  double low() const { return low_.h; }
  double high() const { return high_.h; }
  void replace_third(Sample sample) { third_ = std::move(sample); }
  void raise_low(Sample sample) { third_ = std::exchange(low_, std::move(sample)); }
  void lower_high(Sample sample) { third_ = std::exchange(high_, std::move(sample)); }
  /// Infinity if no corner comes down in between, not even one that is lifted again before the end.
  double root() const {
    double first = never;
    for (const std::size_t i : coming_) {
      const auto at = [&](const Sample& sample) { return sample.clearances[i] - near_ / 4; };
      if (!(at(low_) > 0)) continue;
      const double width = high_.h - low_.h, slope = (at(high_) - at(low_)) / width;
      const double bend = ((at(third_) - at(high_)) / (third_.h - high_.h) - slope) / (third_.h - low_.h);
      const ClearanceCurve curve{low_.h, width, at(low_), slope - bend * width, bend};
      if (std::min(at(high_), curve.least()) < -near_ / 4) first = std::min(first, curve.root());
    }
    return first;
  }

 private:
  Sample low_, third_, high_;
  double near_;
  std::vector<std::size_t> coming_;
};

/// Whether two parts press on each other in the step and are apart after it: a part slides off where the face or the
/// edge that it is on ends.
bool slides_off(const ContactGraph& graph, const StepPlan& plan) {
  const std::vector<State>& after = plan.stepped.after;
  std::span<const contact::ContactConstraint> left = plan.constraints;
  for (const ContactPair& contact_pair : graph.contact_pairs()) {
    const auto of_pair = left.first(contact_pair.contact_points.size());
    left = left.subspan(of_pair.size());
    const std::size_t a = graph.index(contact_pair.a), b = graph.index(contact_pair.b);
    if (have_come_apart(contact_pair, of_pair, graph.bodies()[a], after[a], graph.bodies()[b], after[b],
                        lost * graph.near()))
      return true;
  }
  return false;
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

/// A step in which a part slides off another ends there.
StepPlan until_one_slides_off(const ContactGraph& graph, StepPlan plan, double longest) {
  if (!slides_off(graph, plan)) return plan;
  double low = 0;
  for (int k = 0; k < cuts_at_end_of_contact; ++k) {
    StepPlan shorter = solve_step(graph, (low + plan.h) / 2, longest);
    if (slides_off(graph, shorter)) {
      plan = std::move(shorter);
    } else {
      low = shorter.h;
    }
  }
  return plan;
}

bool has_few_bodies(const ContactGraph& graph) {
  return std::ranges::count_if(graph.bodies(), [](const IslandBody& body) { return !body.fixed(); }) <= few_bodies;
}

/// m/s: slip that a step of h need not end for. In a pile some slip ends in nearly each step, and a heap would take six
/// times as long, so among many bodies only slip counts that is faster than what gravity makes in a step.
double negligible_slip(const ContactGraph& graph, double h) {
  double greatest = 0;
  for (const IslandBody& island_body : graph.bodies())
    greatest = std::max(greatest, length(island_body.step_body.acceleration));
  const double rebound = share_of_rebound * std::sqrt(2 * greatest * graph.near());
  return std::max({graph.near() / h, rebound, has_few_bodies(graph) ? 0 : greatest * h});
}

/// The share of a step after which the first contact has no slip, if friction reverses it then; 1 if none.
double slip_ends(const StepPlan& plan, double negligible) {
  double share = 1;
  for (const contact::Slip& slip : plan.stepped.slips) {
    if (slip.before > negligible && slip.after < -negligible)
      share = std::min(share, slip.before / (slip.before - slip.after));
  }
  return share;
}

/// A step that ends where the first contact stops slipping: friction has another direction then, or holds.
StepPlan until_slip_ends(const ContactGraph& graph, StepPlan plan, double longest) {
  const double negligible = negligible_slip(graph, longest);
  for (int k = 0; k < most_slip_cuts; ++k) {
    const double share = slip_ends(plan, negligible);
    if (share == 1) break;
    plan = solve_step(graph, share * plan.h, longest);
  }
  return plan;
}

/// Whether a contact with friction stops pressing within the step, if its force changes linearly.
bool loses_friction(const ContactGraph& graph, const StepPlan& plan) {
  const std::vector<contact::ContactConstraint> last = constraints(graph);
  for (std::size_t i = 0; i < last.size(); ++i) {
    const auto force = [&](const contact::ContactConstraint& in) { return in.about.dot(in.contact_point.F_A_W); };
    if (last[i].friction > 0 && force(plan.constraints[i]) < least_share_of_force * force(last[i])) return true;
  }
  return false;
}

bool slips(const StepPlan& plan, double negligible) {
  return std::ranges::any_of(plan.stepped.slips, [=](const contact::Slip& slip) { return slip.before > negligible; });
}

/// J; the energy that the bodies lose in the step. As a difference: places far away would lose digits in a potential.
double dissipated(const ContactGraph& graph, const StepPlan& plan) {
  double sum = 0;
  for (std::size_t i = 0; i < graph.bodies().size(); ++i) {
    if (graph.bodies()[i].fixed()) continue;
    contact::StepBody body = graph.bodies()[i].step_body;
    const double before = body.kinetic_energy();
    body.state = plan.stepped.after[i];
    const double work = body.model->mass * plan.h * body.acceleration.dot(plan.stepped.mean[i].v);
    sum += before - body.kinetic_energy() + work;
  }
  return sum;
}

/// A step that ends where a contact that slips stops pressing. Forces are solved for as means over a step, so in a
/// longer one friction would take less energy: seen in between, energy would rise. It is least here (golden section).
StepPlan until_friction_ends(const ContactGraph& graph, StepPlan plan, double longest) {
  if (!has_few_bodies(graph) || !loses_friction(graph, plan)) return plan;
  double low = 0, high = plan.h;
  StepPlan best = solve_step(graph, golden * high, longest);
  if (!slips(best, negligible_slip(graph, longest))) return plan;
  double most = dissipated(graph, best);
  for (int k = 0; k < most_friction_cuts; ++k) {
    StepPlan other = solve_step(graph, low + (high - best.h), longest);
    if (const double more = dissipated(graph, other); more > most) {
      std::swap(best, other);
      most = more;
    }
    (other.h < best.h ? low : high) = other.h;
  }
  return std::move(most > dissipated(graph, plan) ? best : plan);
}

/// A step that ends where the first corner comes down.
StepPlan until_one_comes_down(const ContactGraph& graph, StepPlan plan, double longest) {
  const double near = graph.near(), h = plan.h;
  const std::vector<double> before = clearances(graph, states_of(graph));
  Sample end{plan.h, clearances(graph, plan.stepped.after)};
  ClearanceLeft left = clearance_left(before, end.clearances, near);
  if (left.least >= 0 && !may_come_down(graph, before, h)) return plan;
  CornerSearch search({0, before}, clearance_rates(graph), std::move(end), near);
  if (left.least >= -near / 4 && search.root() < plan.h) {
    // Rates along the present normals may be too low, as another normal may separate the two parts farther at once.
    std::vector<contact::ContactConstraint> none;
    const double moment = share_of_moment * h;
    const std::vector<State> moved = step(step_bodies(graph), none, moment, accuracy(graph), near / h).after;
    search.replace_third({moment, clearances(graph, moved)});
  }
  // Forces depend on the length of the step, so a corner may come down in shorter ones although neither its rate at the
  // start nor the whole step says so. One that is hardly above another is looked at once more.
  bool is_open = std::ranges::any_of(
      before, [near](double clearance) { return clearance > near && clearance < hardly_above * near; });
  for (int k = 1; k <= most_halvings && plan.h > least_share_of_step * h; ++k) {
    const bool is_deep = left.least < -near / 4;
    const double root = is_deep && k % steps_per_halving == 0 ? never : search.root();
    const bool is_between = root > search.low() && root < search.high();
    if (!is_deep && !is_between && !std::exchange(is_open, false)) break;
    const double between = search.low() + (is_deep ? 0.5 : early_share) * (search.high() - search.low());
    StepPlan shorter = solve_step(graph, is_between ? root : between, longest);
    Sample sample{shorter.h, clearances(graph, shorter.stepped.after)};
    const ClearanceLeft found = clearance_left(before, sample.clearances, near);
    if (found.least >= 0 && !(found.coming <= near / 4)) {
      search.raise_low(std::move(sample));
    } else {
      search.lower_high(std::move(sample));
      plan = std::move(shorter);
      left = found;
    }
  }
  return plan;
}

StepPlan plan_step(const ContactGraph& graph, double h, double longest) {
  StepPlan plan = until_slip_ends(graph, solve_step(graph, h, longest), longest);
  plan = until_friction_ends(graph, std::move(plan), longest);
  return until_one_slides_off(graph, until_one_comes_down(graph, std::move(plan), longest), longest);
}

double deepest(const ContactGraph& graph, const StepPlan& plan) {
  return std::max(0.0, -std::ranges::min(clearances(graph, plan.stepped.after)));
}

StepDeviation deviation(const ContactGraph& graph, const StepPlan& plan) {
  const double h = plan.h;
  std::vector<double> change(graph.bodies().size(), 0.0);
  for (const contact::ContactConstraint& constraint : plan.constraints) {
    const double force = 2 * (1 + constraint.friction) * length(constraint.contact_point.F_A_W);
    for (const std::size_t i : {constraint.a, constraint.b})
      change[i] += force * graph.bodies()[i].body->inverse_mass();
  }
  StepDeviation most;
  for (std::size_t i = 0; i < graph.bodies().size(); ++i) {
    const IslandBody& island_body = graph.bodies()[i];
    if (island_body.fixed()) continue;
    const Velocity &before = island_body.state().velocity, &after = plan.stepped.after[i].velocity;
    const double turn = h * length(plan.stepped.mean[i].w);
    const double spun = h * length(after.w_WB - before.w_WB) / 4 + turn * turn * turn / 8;
    const double bent = h * length(after.v_WBcm - before.v_WBcm) / 4;
    const double radius = island_body.body->kind() == Kind::ball ? 0 : island_body.body->radius();
    most.margin = std::max(most.margin, spun * radius + bent);
    most.acceleration = std::max(most.acceleration, change[i]);
  }
  return most;
}

}  // namespace touchstone::fast::simulation
