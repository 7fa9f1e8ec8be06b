#include "fast/simulation/simultaneous_impact.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "fast/mark.h"
#include "fast/simulation/impact_event.h"
#include "fast/simulation/island/island_event.h"
#include "fast/simulation/response.h"
#include "fast/simulation/rest/resting_contact.h"
#include "fast/simultaneous/round.h"

namespace touchstone::fast::simulation {
namespace {

constexpr double acts_above = 2;         // rebound speeds: a slower approach is not an impact, as in islands
constexpr double acts_beside = 0x1p-20;  // of the pair's approach: a slower one is due much later
constexpr double one_normal = 0x1p-20;   // difference of the normals of one region
constexpr int most_centre_iterations = 24;
constexpr double centre_tolerance = 0x1p-44;  // of the approach
constexpr double least_relaxation = 0x1p-4;

double fastest(const PairPoints& points) {
  double u_n = points.front().u_n;
  for (const ImpactCandidate& point : points) u_n = std::min(u_n, point.u_n);
  return u_n;
}

bool is_one_region(const PairPoints& p, const PairPoints& q) {
  const ImpactCandidate &at = p.front(), &by = q.front();
  return at.a == by.a && at.b == by.b && (at.touch.nhat_BA_W - by.touch.nhat_BA_W).norm() <= one_normal;
}

/// Two bodies and their contact points, in the form that the laws of several points take.
struct Bodies {
  std::vector<BodyId> ids;
  std::vector<contact::Mobility> mobilities;
  std::vector<contact::Twist> twists;
  std::vector<Vec3> centres;

  int index(const Run& run, BodyId id) {
    const auto found = std::ranges::find(ids, id);
    if (found != ids.end()) return static_cast<int>(found - ids.begin());
    const contact::StepBody body{&run.world.body(id).model(), run.islands.state(id), Vec3::Zero()};
    ids.push_back(id);
    mobilities.push_back(body.mobility());
    twists.push_back({body.state.velocity.v_WBcm, body.state.velocity.w_WB});
    centres.push_back(body.transform().centre);
    return static_cast<int>(ids.size()) - 1;
  }

  contact::ContactRow row(const Run& run, const ImpactCandidate& point) {
    contact::ContactRow row;
    row.a = index(run, point.a);
    row.b = index(run, point.b);
    row.n = point.touch.nhat_BA_W;
    row.arm_A = point.touch.p_WC - centres[contact::index(row.a)];
    row.arm_B = point.touch.p_WC - centres[contact::index(row.b)];
    row.friction = run.world.coefficients(point.a, point.b).friction;
    return row;
  }
};

/// A touch at the mean of the points, weighted with p ≥ 0: a point itself if it alone has a weight, and none if none
/// has. Several points have one normal; its gap is that of the first.
template <class Weight>
std::optional<Touch> weighted_mean(const PairPoints& points, const Weight& weight) {
  std::optional<Touch> mean;
  double sum = 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const double p = weight(k);
    if (!(p > 0)) continue;
    sum += p;
    if (!mean) {
      mean = points[k].touch;
      continue;
    }
    mean->p_WC += p / sum * (points[k].touch.p_WC - mean->p_WC);
  }
  return mean;
}

/// The search for the centre of pressure of one region.
class PressureCentre {
 public:
  PressureCentre(const Run& run, const PairPoints& points)
      : run_(&run),
        points_(&points),
        a_(points.front().a),
        b_(points.front().b),
        at_a_(run.islands.state(a_)),
        at_b_(run.islands.state(b_)),
        coefficients_(run.world.coefficients(a_, b_)) {
    for (const ImpactCandidate& point : points) rows_.push_back(bodies_.row(run, point));
  }

  /// Where a compression presses that has the velocities `twists` and ends with the normal velocity `least_u_n`.
  std::optional<Touch> pressed(const std::vector<contact::Twist>& twists, double least_u_n) const {
    const Eigen::VectorXd p = simultaneous::compression(rows_, bodies_.mobilities, twists, least_u_n);
    return weighted_mean(*points_, [&](std::size_t k) { return p[static_cast<Eigen::Index>(k)]; });
  }
  std::optional<Touch> without_friction() const { return pressed(bodies_.twists, 0); }

  /// Relaxation towards the fixed point C = pressed(friction at C), with Aitken's factor.
  Touch with_friction(const Touch& start) const {
    Touch at = start, best = start;
    double least_miss = never, relaxation = 1;
    Vec3 step_before = Vec3::Zero();
    for (int k = 0; k < most_centre_iterations; ++k) {
      const std::optional<Mean> mean = mean_after(at);
      if (!mean) break;
      if (mean->miss < least_miss) least_miss = mean->miss, best = at;
      if (mean->miss <= -centre_tolerance * mean->u_n) break;
      const std::optional<Touch> next = pressed(mean->with_friction, mean->at_centre);
      if (!next) break;
      const Vec3 step = next->p_WC - at.p_WC, change = step - step_before;
      if (k > 0 && !change.isZero(0)) {
        relaxation = std::clamp(-relaxation * step_before.dot(change) / change.squaredNorm(), least_relaxation, 1.0);
      }
      at.p_WC += relaxation * step;
      step_before = step;
    }
    return best;
  }

 private:
  /// The mean (u_n' + e u_n)/(1 + e) of an impact at one point.
  struct Mean {
    double u_n = 0;                             ///< m/s; before, at the point
    double at_centre = 0;                       ///< m/s
    double miss = 0;                            ///< m/s; by how much it is less elsewhere in the region
    std::vector<contact::Twist> with_friction;  ///< the velocities before, and those that friction adds to the mean
  };

  std::optional<Mean> mean_after(const Touch& at) const {
    const BodyMotion &a = run_->world.body(a_), &b = run_->world.body(b_);
    mark(Mark::centre_step);
    const ImpactResult result = impact(a, at_a_, b, at_b_, at, coefficients_);
    if (!(result.u_n < 0)) return {};
    Mean mean;
    mean.u_n = result.u_n;
    mean.with_friction = bodies_.twists;
    contact::ContactRow row = rows_.front();
    row.arm_A += at.p_WC - points_->front().touch.p_WC;
    row.arm_B += at.p_WC - points_->front().touch.p_WC;
    const Vec3 P = result.P_A_W / (1 + coefficients_.restitution), P_n = row.n.dot(P) * row.n;
    apply_impulse(row, P - P_n, bodies_.mobilities, mean.with_friction);
    std::vector<contact::Twist> twists = mean.with_friction;
    apply_impulse(row, P_n, bodies_.mobilities, twists);
    mean.at_centre = row.n.dot(relative_velocity(row, twists));
    for (const contact::ContactRow& point : rows_)
      mean.miss = std::max(mean.miss, mean.at_centre - point.n.dot(relative_velocity(point, twists)));
    return mean;
  }

  const Run* run_;
  const PairPoints* points_;
  BodyId a_, b_;
  State at_a_, at_b_;
  Coefficients coefficients_;
  Bodies bodies_;
  std::vector<contact::ContactRow> rows_;
};

/// Of one contact. Without P it is that of the law of impact at the touch.
struct ContactImpulse {
  BodyId a = 0, b = 0;
  Touch touch;
  std::optional<Vec3> P_A_W;
};

ContactImpulse lone_impulse(const Run& run, const PairPoints& points) {
  return {points.front().a, points.front().b, centre_of_pressure(run, points), {}};
}

/// The impulses of contacts that share bodies which move. If one of them alone presses, it is a lone contact.
std::vector<ContactImpulse> act_together(const Run& run, const std::vector<PairPoints>& contacts) {
  std::vector<ContactImpulse> impulses;
  std::vector<std::size_t> presses;  // contacts
  Bodies bodies;
  std::vector<simultaneous::Region> regions;
  std::vector<std::size_t> region_of, first_of;  // indexed by contact: its region, and the first of its points there
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const PairPoints& points = contacts[i];
    std::size_t region = regions.size();
    for (std::size_t j = 0; j < i; ++j) {
      if (is_one_region(points, contacts[j])) region = region_of[j];
    }
    if (region == regions.size())
      regions.push_back({run.world.coefficients(points.front().a, points.front().b).restitution, {}});
    region_of.push_back(region);
    first_of.push_back(regions[region].points.size());
    for (const ImpactCandidate& point : points) regions[region].points.push_back(bodies.row(run, point));
  }
  simultaneous::act(regions, bodies.mobilities, bodies.twists);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const PairPoints& points = contacts[i];
    const auto row = [&](std::size_t k) -> const contact::ContactRow& {
      return regions[region_of[i]].points[first_of[i] + k];
    };
    if (row(0).friction > 0) {
      for (std::size_t k = 0; k < points.size(); ++k) {
        if (row(k).P.isZero(0)) continue;
        impulses.push_back({points[k].a, points[k].b, points[k].touch, row(k).P});
        if (presses.empty() || presses.back() != i) presses.push_back(i);
      }
      continue;
    }
    const std::optional<Touch> centre = weighted_mean(points, [&](std::size_t k) { return row(k).n.dot(row(k).P); });
    if (!centre) continue;
    Vec3 P = Vec3::Zero();
    for (std::size_t k = 0; k < points.size(); ++k) P += row(k).P;
    impulses.push_back({points.front().a, points.front().b, *centre, P});
    presses.push_back(i);
  }
  if (presses.size() == 1) return {lone_impulse(run, contacts[presses.front()])};
  return impulses;
}

/// The contacts, in components that share no body which moves.
std::vector<std::vector<PairPoints>> separate(const Run& run, const std::vector<PairPoints>& contacts) {
  if (contacts.size() == 1) return {contacts};
  Bodies bodies;
  std::vector<simultaneous::Region> regions;
  for (const PairPoints& points : contacts) regions.push_back({0, {bodies.row(run, points.front())}});
  std::vector<std::vector<PairPoints>> parts;
  for (const std::vector<std::size_t>& part : simultaneous::components(regions, bodies.mobilities)) {
    std::vector<PairPoints>& some = parts.emplace_back();
    for (const std::size_t i : part) some.push_back(contacts[i]);
  }
  return parts;
}

/// Of several contacts that are one region: those that press without friction. Parts of a body may touch at one point.
/// Where rounding hides which press, the one that approaches fastest.
std::vector<PairPoints> pressing(const Run& run, const std::vector<PairPoints>& contacts) {
  Bodies bodies;
  std::vector<contact::ContactRow> rows;
  for (const PairPoints& points : contacts) {
    for (const ImpactCandidate& point : points) rows.push_back(bodies.row(run, point));
  }
  const Eigen::VectorXd p = simultaneous::compression(rows, bodies.mobilities, bodies.twists, 0);
  std::vector<PairPoints> some;
  Eigen::Index first = 0;
  for (const PairPoints& points : contacts) {
    const auto count = static_cast<Eigen::Index>(points.size());
    if (p.segment(first, count).sum() > 0) some.push_back(points);
    first += count;
  }
  if (some.empty()) some.push_back(*std::ranges::min_element(contacts, {}, fastest));
  return some;
}

/// Whether two bodies have one contact point.
bool touch_at_a_point(const Run& run, BodyId a, BodyId b) {
  return has_closed_form(run.world.body(a), run.world.body(b)) && !run.islands.of(a) && !run.islands.of(b);
}

/// The contacts of a pair in ballistic motion or in an island; none if the two are farther apart than the envelope.
std::vector<PairPoints> contacts_of(Run& run, BodyId a, BodyId b) {
  const World& world = run.world;
  const BodyMotion &A = world.body(a), &B = world.body(b);
  if (touch_at_a_point(run, a, b)) {
    const Touch touch = run.schedule.nearest_points(a, b, world.now());
    if (touch.gap > world.envelope()) return {};
    return {{{a, b, touch, normal_velocity(A, run.islands.state(a), B, run.islands.state(b), touch)}}};
  }
  return contact_points_of(run, a, b);
}

/// Whether two bodies that have started are within the envelope of each other: the balls around them, and their boxes.
bool is_near(const Run& run, const BodyPair& pair) {
  const World& world = run.world;
  const BodyMotion &a = world.body(pair.a), &b = world.body(pair.b);
  const double reach = a.radius() + b.radius() + world.envelope();
  if ((a.path().place(world.now()) - b.path().place(world.now())).squaredNorm() > reach * reach) return false;
  if (a.kind() == Kind::ball && b.kind() == Kind::ball) return true;
  return overlap(a.box(world.now(), world.now(), world.envelope()), b.box(world.now(), world.now(), 0));
}

/// Whether the body has started, and its state is known at the current time without the end of a step.
bool is_current(const Run& run, BodyId id) {
  if (run.world.start_time(id) > run.world.now()) return false;
  const Island* island = run.islands.of(id);
  return !island || (island->waits() && island->since() == run.world.now());
}

bool may_touch(const Run& run, BodyId id, BodyId other) { return is_current(run, other) && is_near(run, {id, other}); }

/// The bodies whose contacts with a body are to be looked at, sorted.
std::vector<BodyId> near_bodies(Run& run, BodyId id) {
  std::vector<BodyId> near;
  for (const BodyId other : run.schedule.neighbours(id)) {
    if (may_touch(run, id, other)) near.push_back(other);
  }
  std::ranges::sort(near);
  return near;
}

/// Whether the event queue alone shows that no contact of a third body acts with that of the pair. A contact that acts
/// has a gap of at most the envelope ε and approaches with s > max(acts_above · √(2 A ε), acts_beside · |u_n|), where A
/// is the larger acceleration of its two bodies. The relative acceleration is at most 2 A, so the gap ε − s t + A t² is
/// closed before t = 2 ε / s, and the queue of a world of balls and blocks has an event of that pair. Bodies that pass
/// each other within the envelope but never touch have none; they do not act.
bool is_only_one_due(const Run& run, BodyId a, BodyId b, double u_n) {
  const World& world = run.world;
  if (!run.has_closed_forms || !run.islands.all().empty()) return false;
  double least_square = never;
  for (const BodyId id : {a, b}) {
    if (!world.body(id).fixed()) least_square = std::min(least_square, world.acceleration(id).squaredNorm());
  }
  const double slowest =
      std::max(acts_above * micro_bounce_speed(std::sqrt(least_square), world.envelope()), -acts_beside * u_n);
  const double until = world.now() + 2 * world.envelope() / slowest;
  const PairEvent* next = run.schedule.next();
  return until <= run.schedule.frame_end() && (next == nullptr || next->time > until);
}

}  // namespace

std::vector<PairPoints> acting(const std::vector<PairPoints>& contacts,
                               const std::function<double(BodyId, BodyId)>& slow) {
  std::vector<PairPoints> some;
  for (const PairPoints& points : contacts) {
    const double slowest = slow(points.front().a, points.front().b);
    const auto acts = [&](const PairPoints& other) {
      return fastest(other) < -slowest && (&other == &points || is_one_region(other, points));
    };
    if (std::ranges::any_of(contacts, acts)) some.push_back(points);
  }
  return some;
}

bool acts_alone(Run& run, BodyId a, BodyId b, double u_n) {
  if (!touch_at_a_point(run, a, b)) return false;
  if (is_only_one_due(run, a, b, u_n)) return true;
  const auto is_beside = [&](BodyId id, BodyId partner) {
    return !run.world.body(id).fixed() && std::ranges::any_of(run.schedule.neighbours(id), [&](BodyId other) {
      return other != partner && may_touch(run, id, other);
    });
  };
  return !is_beside(a, b) && !is_beside(b, a);
}

std::vector<PairPoints> acting_with(Run& run, BodyId a, BodyId b, const Touch& touch,
                                    const std::vector<PairPoints>& points) {
  const World& world = run.world;
  const BodyMotion &A = world.body(a), &B = world.body(b);
  const double u_n = normal_velocity(A, run.islands.state(a), B, run.islands.state(b), touch);
  std::vector<PairPoints> all = acting(points, [&](BodyId, BodyId) { return -acts_beside * u_n; });
  if (all.empty()) all = {{{a, b, touch, u_n}}};
  std::vector<BodyPair> asked{{a, b}};
  std::vector<BodyId> reached;
  const auto reach = [&](BodyId id) {
    if (!world.body(id).fixed() && std::ranges::count(reached, id) == 0) reached.push_back(id);
  };
  reach(a);
  reach(b);
  // Only if another contact is due may one act that is connected through contacts that do not approach.
  const PairEvent* next = run.schedule.next();
  const bool another_is_due = next != nullptr && next->time <= world.now() - world.envelope() / u_n;
  for (std::size_t i = 0; i < reached.size(); ++i) {
    for (const BodyId other : near_bodies(run, reached[i])) {
      const BodyPair pair{std::min(reached[i], other), std::max(reached[i], other)};
      if (std::ranges::count(asked, pair) > 0) continue;
      asked.push_back(pair);
      const std::vector<PairPoints> contacts = contacts_of(run, pair.a, pair.b);
      const std::vector<PairPoints> fast = acting(contacts, [&](BodyId p, BodyId q) {
        return std::max(acts_above * rebound_speed(world, run.islands, p, q), -acts_beside * u_n);
      });
      all.insert(all.end(), fast.begin(), fast.end());
      if (!fast.empty() || (another_is_due && !contacts.empty())) reach(other);
    }
  }
  return all;
}

Touch centre_of_pressure(const Run& run, const PairPoints& points) {
  const auto approach = [](const ImpactCandidate& point) { return point.u_n; };
  if (points.size() == 1) return points.front().touch;
  const PressureCentre centre(run, points);
  const std::optional<Touch> pressed = centre.without_friction();
  if (!pressed) return std::ranges::min_element(points, {}, approach)->touch;
  const bool is_rough = run.world.coefficients(points.front().a, points.front().b).friction > 0;
  return is_rough ? centre.with_friction(*pressed) : *pressed;
}

void resolve_impacts(Run& run, const std::vector<PairPoints>& contacts) {
  std::vector<ContactImpulse> impulses;
  for (std::vector<PairPoints>& part : separate(run, contacts)) {
    if (part.size() > 1 &&
        std::ranges::all_of(part, [&](const PairPoints& p) { return is_one_region(p, part.front()); }))
      part = pressing(run, part);
    if (part.size() == 1) {
      impulses.push_back(lone_impulse(run, part.front()));
    } else {
      mark(Mark::impact_together);
      const std::vector<ContactImpulse> together = act_together(run, part);
      impulses.insert(impulses.end(), together.begin(), together.end());
    }
  }
  std::ranges::stable_sort(impulses, {},
                           [](const ContactImpulse& impulse) { return std::tuple(impulse.a, impulse.b); });
  for (const ContactImpulse& impulse : impulses) {
    const BodyMotion &a = run.world.body(impulse.a), &b = run.world.body(impulse.b);
    const State at_a = run.islands.state(impulse.a), at_b = run.islands.state(impulse.b);
    apply_impulse(run, Event::Kind::impact, impulse.a, impulse.b, impulse.touch,
                  impulse.P_A_W
                      ? impulse_at(a, at_a, b, at_b, impulse.touch, *impulse.P_A_W)
                      : impact(a, at_a, b, at_b, impulse.touch, run.world.coefficients(impulse.a, impulse.b)));
  }
}

}  // namespace touchstone::fast::simulation
