// The clause of docs/spec/simulation.md about the energy of impacts at one time, judged by the conditions that hold for
// whatever law (reference/impact_conditions.h).
#include <algorithm>
#include <cmath>
#include <optional>

#include "oracle/judge/words.h"
#include "oracle/tolerance/impulse.h"
#include "oracle/tolerance/motion.h"
#include "oracle/tolerance/tolerance.h"
#include "oracle/truth/impact.h"
#include "oracle/truth/motion_in_doubles.h"
#include "oracle/truth/truth.h"
#include "properties/cases/time_of_impact_case.h"
#include "properties/cases/trajectory_case.h"
#include "properties/queries.h"

namespace touchstone::properties {
namespace {

using oracle::Defect;
using oracle::Finding;
using oracle::ImpactBody;
using oracle::Real;
using oracle::Subject;
using reference::ImpactCondition;
using reference::ReportedImpacts;
namespace judge = oracle::judge;
namespace tolerance = oracle::tolerance;

/// The events of one time that are connected through bodies that move, and these bodies.
struct Instant {
  std::vector<std::size_t> events, bodies;

  bool has(int body) const { return std::ranges::count(bodies, static_cast<std::size_t>(body)) > 0; }
};

/// The bodies of an event that move.
std::vector<int> moving_bodies(const TrajectoryCase& asked, const Event& event) {
  std::vector<int> moving;
  for (const int body : {event.a, event.b}) {
    if (body >= 0 && !asked.is_fixed(static_cast<std::size_t>(body))) moving.push_back(body);
  }
  return moving;
}

/// Adds an event. All instants that it connects become one.
void add(std::vector<Instant>& instants, std::size_t event, const std::vector<int>& moving) {
  Instant all;
  std::erase_if(instants, [&](const Instant& instant) {
    if (std::ranges::none_of(moving, [&](int body) { return instant.has(body); })) return false;
    all.events.insert(all.events.end(), instant.events.begin(), instant.events.end());
    all.bodies.insert(all.bodies.end(), instant.bodies.begin(), instant.bodies.end());
    return true;
  });
  all.events.push_back(event);
  for (const int body : moving) {
    if (!all.has(body)) all.bodies.push_back(static_cast<std::size_t>(body));
  }
  std::ranges::sort(all.events);
  instants.push_back(std::move(all));
}

/// A choice: the cost of exact numbers grows with the cube of the number of impacts.
constexpr std::size_t most_impacts = 24;

/// Those of several events, of which all are impacts.
std::vector<Instant> instants_of_impacts(const TrajectoryCase& asked) {
  const std::vector<Event>& events = *asked.said.events;
  std::vector<Instant> all, now;
  for (std::size_t e = 0; e < events.size(); ++e) {
    if (e > 0 && events[e].time != events[e - 1].time) {
      all.insert(all.end(), now.begin(), now.end());
      now.clear();
    }
    add(now, e, moving_bodies(asked, events[e]));
  }
  all.insert(all.end(), now.begin(), now.end());
  std::erase_if(all, [&](const Instant& instant) {
    const auto is_impact = [&](std::size_t e) { return events[e].kind == Event::Kind::impact; };
    return instant.events.size() < 2 || instant.events.size() > most_impacts ||
           !std::ranges::all_of(instant.events, is_impact);
  });
  return all;
}

/// What is reported of an instant, and what the energies of its bodies may be off by.
class ReportedInstant {
 public:
  /// None if a body is not in ballistic motion before.
  static std::optional<ReportedInstant> of(const TrajectoryCase& asked, const Timeline& timeline,
                                           const Instant& instant) {
    ReportedInstant it(asked);
    for (const std::size_t e : instant.events) {
      const Event& event = (*asked.said.events)[e];
      const std::vector<Segment> segments = segments_into(timeline, asked.said, e);
      for (std::size_t side = 0; side < 2; ++side) {
        const Segment& segment = segments[side];
        if (it.index(segment.body)) continue;
        if (!segment.ballistic) return std::nullopt;
        it.add_body(segment, event.time, (side == 0 ? event.after_a : event.after_b).X_WB);
      }
      it.add_impulse(event);
    }
    return it;
  }

  const ReportedImpacts& reported() const { return reported_; }
  Real energy_before() const { return energy(reported_.before.bodies); }
  Real energy_after() const {
    std::vector<Body> bodies = reported_.before.bodies;
    for (std::size_t k = 0; k < bodies.size(); ++k) bodies[k].velocity = reported_.after[k];
    return energy(bodies);
  }

  /// Whether rounding leaves each impact its digits, at the velocities before all of them.
  bool is_in_range() const {
    return std::ranges::all_of(
        impacts_, [&](const oracle::Impact& impact) { return tolerance::impact_in_range(impact, asked_->precision); });
  }

  /// J. All energies are sums of terms of which each event rounds those of its two bodies; the errors of the masses and
  /// of the velocities before come on top, and that of the solution for the impulses.
  judge::Allowance allowance() const {
    Real size = 0, off = 0;
    for (const Real term : terms_) size += term;
    for (std::size_t k = 0; k < ids_.size(); ++k) off = std::max(off, mass_error(k));
    const double unit = oracle::unit_roundoff(asked_->precision) * std::max(static_cast<double>(size), 0x1p-900);
    const double rounded = tolerance::accumulated(impacts_.size(), ids_.size()) * unit;
    const double bound = rounded + static_cast<double>(off * size + before_) +
                         tolerance::solved_together(energy_norms_, asked_->precision);
    return {bound, unit, "ulps of the energies", 0, static_cast<double>(size)};
  }

 private:
  explicit ReportedInstant(const TrajectoryCase& asked) : asked_(&asked) {
    reported_.before.motion = asked.scene.motion;
  }

  std::optional<std::size_t> index(std::size_t id) const {
    const auto found = std::ranges::find(ids_, id);
    if (found == ids_.end()) return std::nullopt;
    return static_cast<std::size_t>(found - ids_.begin());
  }

  static Real energy(const Scene& scene, std::size_t k) {
    const ImpactBody body = oracle::impact_body(scene, k, Vec3::Zero());
    if (body.fixed) return 0;
    return (body.mass * body.v_WBcm.squaredNorm() + body.spin_energy_twice(body.w_WB)) / 2;
  }
  static Real energy(const std::vector<Body>& bodies) {
    Scene scene;
    scene.bodies = bodies;
    Real sum = 0;
    for (std::size_t k = 0; k < bodies.size(); ++k) sum += energy(scene, k);
    return sum;
  }

  void add_body(const Segment& segment, double time, const Pose& X_WB) {
    const Scene alone = segment_scene(asked_->scene, {segment}, time);
    Body body = alone.bodies.front();
    body.X_WB = X_WB;
    body.velocity = oracle::ballistic_state(alone, 0, time).velocity;
    ids_.push_back(segment.body);
    reported_.before.bodies.push_back(body);
    reported_.after.push_back(body.velocity);
    const std::size_t k = ids_.size() - 1;
    terms_.push_back(energy(reported_.before, k));
    const ImpactBody weight = oracle::impact_body(reported_.before, k, Vec3::Zero());
    if (weight.fixed) return;
    const tolerance::BallisticBound flown = properties::allowance(alone, 0, time, asked_->precision);
    before_ += weight.mass * (weight.v_WBcm.norm() + flown.velocity) * flown.velocity +
               weight.moments[2] * (weight.w_WB.norm() + flown.spin) * flown.spin;
  }

  void add_impulse(const Event& event) {
    const std::size_t a = *index(static_cast<std::size_t>(event.a)), b = *index(static_cast<std::size_t>(event.b));
    reported_.regions.push_back({static_cast<int>(a), static_cast<int>(b), event.nhat_BA_W, {event.p_WC}});
    reported_.impulses.push_back({reported_.regions.size() - 1, event.p_WC, event.P_A_W});
    Scene pair;
    pair.bodies = {reported_.before.bodies[a], reported_.before.bodies[b]};
    pair.contact = Contact{event.p_WC, event.nhat_BA_W, Law::poisson, 0, 0};
    impacts_.push_back(oracle::impact(pair));
    const oracle::Point P = event.P_A_W.cast<Real>();
    energy_norms_.push_back(std::sqrt(std::max<Real>(0, P.dot(impacts_.back().K * P))));
    pair.bodies[0].velocity = reported_.after[a] = event.after_a.velocity;
    pair.bodies[1].velocity = reported_.after[b] = event.after_b.velocity;
    terms_.push_back(energy(pair, 0));
    terms_.push_back(energy(pair, 1));
  }

  /// 1: of a body's energy, from the errors of its mass and moments, and of the turn by q into its axes and back.
  Real mass_error(std::size_t k) const {
    const ImpactBody body = oracle::impact_body(reported_.before, k, Vec3::Zero());
    if (body.fixed) return 0;
    const tolerance::MassBound bound = tolerance::mass(reported_.before.bodies[k], asked_->precision);
    const Real spread = (body.moments[2] - body.moments[0]) / body.moments[0];
    return bound.mass / body.mass + bound.inertia / body.moments[0] +
           128 * oracle::unit_roundoff(asked_->precision) * spread;
  }

  const TrajectoryCase* asked_;
  std::vector<std::size_t> ids_;
  ReportedImpacts reported_;
  std::vector<oracle::Impact> impacts_;
  std::vector<Real> terms_, energy_norms_;
  Real before_ = 0;  ///< J: by the errors of the velocities before
};

/// Whether bodies can be clamped: convex bodies, of which at most one is fixed, can all move apart at once, along the
/// lines from a point inside the fixed one to points inside them.
bool can_be_clamped(const Scene& scene) {
  const auto is_convex = [](const Body& body) { return !std::holds_alternative<Compound>(body.shape); };
  return std::ranges::count_if(scene.bodies, is_fixed) > 1 || !std::ranges::all_of(scene.bodies, is_convex);
}

Finding together_energy(const Scene& scene, Subject& subject) {
  return of_timeline(scene, subject, [&](const TrajectoryCase& asked, const Timeline& timeline) {
    Finding worst = judge::outside("no impacts of bodies in ballistic motion at one time");
    for (const Instant& instant : instants_of_impacts(asked)) {
      const std::optional<ReportedInstant> said = ReportedInstant::of(asked, timeline, instant);
      if (!said || !said->is_in_range()) continue;
      const Real before = said->energy_before();
      if (!(before > 0)) continue;
      const auto errors = oracle::truth::impact_condition_errors(said->reported());
      const judge::Allowance allowed = said->allowance();
      const auto judged = [&](ImpactCondition condition, const char* law) {
        return counted(4 * allowed.bound < static_cast<double>(before),
                       judge::at_most(
                           errors[static_cast<std::size_t>(condition)] * static_cast<double>(before), allowed,
                           Defect::wrong_energy,
                           [&] {
                             return text((*asked.said.events)[instant.events.front()]) + " and others at that time: " +
                                    oracle::words::text(static_cast<double>(said->energy_after())) + " J";
                           },
                           [&] { return oracle::words::text(static_cast<double>(before)) + law; }));
      };
      if (worse(worst, judged(ImpactCondition::energy, " J, as before, or less"))) return worst;
      const bool is_kept = !can_be_clamped(scene) && asked.dynamics.restitution_threshold == 0;
      if (is_kept && worse(worst, judged(ImpactCondition::elastic, " J, as before"))) return worst;
    }
    return worst;
  });
}

}  // namespace

std::vector<Property> simulation_instant_properties() {
  return {
      {"simulation.together_energy",
       "simulation",
       {"TS-SIMULATION-35"},
       "impacts at one time never increase the energy of their bodies, and elastic ones without friction keep it",
       together_energy},
  };
}

}  // namespace touchstone::properties
