// The clause of docs/spec/simulation.md about bodies under a contact that lasts: something touches them.
#include <algorithm>
#include <string>
#include <vector>

#include "model/limits.h"
#include "oracle/judge/words.h"
#include "oracle/tolerance/motion.h"
#include "oracle/tolerance/tolerance.h"
#include "oracle/truth/truth.h"
#include "properties/cases/overlap_along.h"
#include "properties/cases/trajectory_case.h"
#include "properties/queries.h"

namespace touchstone::properties {
namespace {

using oracle::Defect;
using oracle::Finding;
using oracle::Subject;
namespace judge = oracle::judge;
namespace tolerance = oracle::tolerance;

/// 1: of a body's radius: how far it may leave another within one step in which contacts are solved. It starts at rest
/// relative to the other, so its way is a h²/2, where a is its acceleration without the contact. If h is at most 1/32
/// of the time in which such an acceleration moves the body by its radius, or a rotation turns it by a radian, that is
/// 2⁻¹¹ of the radius for each of the two: a choice.
constexpr double opens_in_a_step = 0x1p-10;

/// Is the body, at this time, after an event that reports a contact that lasts, and before its next event?
bool is_held(const std::vector<Segment>& segments, double time) {
  return std::ranges::any_of(segments, [time](const Segment& segment) {
    return !segment.ballistic && segment.from < time && (time < segment.until || segment.is_last());
  });
}

/// m: how far two bodies of which at least one moves may be apart although a contact between them lasts.
double gap_of_contact(const TrajectoryCase& asked, const Scene& pair) {
  double gap = 2 * envelope(asked.scene) + tolerance::distance(pair, asked.precision);
  if (asked.stepping) gap += tolerance::way_of_step(asked.scene, asked.stepping->step);
  if (!asked.said.contact_solver) return gap;
  for (const Body& body : pair.bodies) gap += is_fixed(body) ? 0 : opens_in_a_step * tolerance::radius(body);
  return gap;
}

/// Does the body, in one sample, touch another? The finding is about the nearest.
Finding touches_another(const TrajectoryCase& asked, std::size_t sample, std::size_t body) {
  const std::vector<State>& states = asked.said.states[sample];
  Finding least = judge::outside("no other body");
  for (std::size_t other = 0; other < states.size(); ++other) {
    if (other == body || !asked.has_started(other, asked.time(sample))) continue;
    const Scene pair = posed_pair(asked.scene, body, states[body].X_WB, other, states[other].X_WB);
    const Interval apart = oracle::truth::distance(pair).distance;
    const double allowed = gap_of_contact(asked, pair) + asked.distances.of(apart.lo);
    Finding finding = judge::at_most(
        apart.lo, in_ulps_of_place(asked, allowed), Defect::phantom,
        [&] {
          return "body " + std::to_string(body) + " is under a contact at " + oracle::words::text(asked.time(sample)) +
                 " s, and body " + std::to_string(other) + " is " + oracle::words::text(apart.lo) + " m away";
        },
        [] { return std::string("a body that touches it"); });
    if (apart.lo <= envelope(asked.scene)) return finding;
    if (least.outcome == oracle::Outcome::outside || finding.error < least.error) least = std::move(finding);
  }
  return least;
}

/// Do the two bodies of a release touch until then?
Finding touches_at_release(const TrajectoryCase& asked, const Event& event) {
  const auto a = static_cast<std::size_t>(event.a), b = static_cast<std::size_t>(event.b);
  const Scene pair = posed_pair(asked.scene, a, event.after_a.X_WB, b, event.after_b.X_WB);
  const Interval apart = oracle::truth::distance(pair).distance;
  const double gap = gap_of_contact(asked, pair) + asked.distances.of(apart.lo);
  Finding worst = judge::at_most(
      apart.lo, in_ulps_of_place(asked, gap), Defect::phantom,
      [&] { return text(event) + ", " + oracle::words::text(apart.lo) + " m apart"; },
      [] { return std::string("two bodies that touch until then"); });
  const auto is_compound = [](const Body& body) { return std::holds_alternative<Compound>(body.shape); };
  if (std::ranges::any_of(pair.bodies, is_compound)) return worst;
  const oracle::Real overlap = overlap_along(event.nhat_BA_W.cast<oracle::Real>(), pair.bodies[0], pair.bodies[1]);
  worse(worst, judge::at_most(
                   std::max(0.0, static_cast<double>(overlap)), in_ulps_of_place(asked, gap), Defect::wrong_normal,
                   [&] { return text(event) + ", n = " + oracle::words::text(event.nhat_BA_W); },
                   [] { return std::string("a normal whose plane separates the two bodies"); }));
  return worst;
}

Finding touches(const Scene& scene, Subject& subject) {
  return of_timeline(scene, subject, [&](const TrajectoryCase& asked, const Timeline& timeline) {
    Finding worst = judge::outside("no sample of a body under a contact that lasts, and no release");
    for (std::size_t sample = 0; sample < asked.samples(); ++sample) {
      for (std::size_t body = 0; body < scene.bodies.size(); ++body) {
        if (asked.is_fixed(body) || !is_held(timeline[body], asked.time(sample))) continue;
        if (worse(worst, touches_another(asked, sample, body))) return worst;
      }
    }
    for (std::size_t e = 0; e < asked.events(); ++e) {
      const Event& event = (*asked.said.events)[e];
      if (event.kind == Event::Kind::release && worse(worst, touches_at_release(asked, event))) break;
    }
    return worst;
  });
}

}  // namespace

std::vector<Property> simulation_lasting_contact_properties() {
  return {{"simulation.touches",
           "simulation",
           {"TS-SIMULATION-42"},
           "a body under a contact that lasts touches another in each sample, and at its release",
           touches}};
}

}  // namespace touchstone::properties
