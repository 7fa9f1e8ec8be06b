#include "properties/cases/simultaneous_impacts.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/limits.h"
#include "oracle/tolerance/tolerance.h"
#include "oracle/truth/impact.h"
#include "oracle/truth/motion_in_doubles.h"
#include "oracle/truth/world_points.h"

namespace touchstone::properties {
namespace {

/// The segment of a body that lasts until an event at its end, or later.
const Segment& segment_before(const Timeline& timeline, int body, std::size_t event) {
  const std::vector<Segment>& segments = timeline[static_cast<std::size_t>(body)];
  return *std::ranges::lower_bound(segments, event, {}, &Segment::ends_with);
}

/// The body's velocity before an event at its time.
Velocity velocity_before(const TrajectoryCase& asked, const Timeline& timeline, int body, std::size_t event) {
  const double time = (*asked.said.events)[event].time;
  return oracle::ballistic_state(segment_scene(asked.scene, {segment_before(timeline, body, event)}, time), 0, time)
      .velocity;
}

/// Points whose convex hull contains what of a convex part is within `near` of a plane through C: its vertices there,
/// and where segments between two vertices enter or leave that layer. A face that tilts may have none of its vertices
/// in it.
oracle::Points near_plane(const oracle::Points& vertices, const oracle::Point& C, const oracle::Point& n, double near) {
  oracle::Points all;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const oracle::Real from = n.dot(vertices[i] - C);
    if (std::abs(from) <= near) all.push_back(vertices[i]);
    for (std::size_t j = 0; j < i; ++j) {
      const oracle::Real to = n.dot(vertices[j] - C);
      for (const double side : {-near, near}) {
        if ((from < side) == (to < side)) continue;
        all.push_back(vertices[i] + (side - from) / (to - from) * (vertices[j] - vertices[i]));
      }
    }
  }
  return all;
}

/// Whether two bodies in contact at C approach at C or elsewhere in their contact region. The region is in the convex
/// hull of A's points near the plane through C, and in that of B's, and u_n is affine over it; so it does not approach
/// if u_n ≥ 0 at all points that span one of the two. Points count as near within four envelopes, and what rounding
/// moves both bodies by: the bodies are within one of each other, C is within one of both, and the rest leaves room for
/// the normal. A ball has no vertices.
bool region_approaches(const Scene& pair, double envelope, oracle::Precision precision) {
  constexpr oracle::Real infinite = std::numeric_limits<oracle::Real>::infinity();
  const oracle::Impact impact = oracle::impact(pair);
  if (impact.u_n() < 0) return true;
  const oracle::Point C = pair.contact->p_WC.cast<oracle::Real>();
  const oracle::Point spin = impact.bodies[0].w_WB - impact.bodies[1].w_WB;
  oracle::Real bound = -infinite;  // of u_n over the region
  const double near = 4 * envelope + 2 * oracle::tolerance::distance(pair, precision);
  for (std::size_t k = 0; k < 2; ++k) {
    oracle::Real least = infinite;
    for (int part = 0;; ++part) {
      const oracle::Points vertices = oracle::world_points(pair.bodies[k], part);
      if (vertices.empty()) break;
      for (const oracle::Point& point : near_plane(vertices, C, impact.nhat_BA_W, near))
        least = std::min(least, impact.nhat_BA_W.dot(impact.u + spin.cross(point - C)));
    }
    if (least == infinite) return false;
    bound = std::max(bound, least);
  }
  return bound < 0;
}

bool same_contact(const Event& e, const Event& f) {
  return e.a == f.a && e.b == f.b && e.p_WC == f.p_WC && e.nhat_BA_W == f.nhat_BA_W &&
         e.after_a.X_WB == f.after_a.X_WB && e.after_b.X_WB == f.after_b.X_WB;
}

bool acts_on(const Event& event, int body) { return event.a == body || event.b == body; }

}  // namespace

const SimultaneousImpacts::Instant& SimultaneousImpacts::at(std::size_t event) {
  if (now_.first <= event && event < now_.end) return now_;
  const std::vector<Event>& events = *asked_.said.events;
  const double time = events[event].time;
  now_.first = static_cast<std::size_t>(std::ranges::lower_bound(events, time, {}, &Event::time) - events.begin());
  now_.end = static_cast<std::size_t>(std::ranges::upper_bound(events, time, {}, &Event::time) - events.begin());
  now_.contact_of.clear();
  now_.approaches.clear();
  std::vector<std::size_t> contacts;
  for (std::size_t k = now_.first; k < now_.end; ++k) {
    const auto known =
        std::ranges::find_if(contacts, [&](std::size_t c) { return same_contact(events[c], events[k]); });
    const bool is_new = known == contacts.end();
    now_.contact_of.push_back(is_new ? k : *known);
    if (is_new) {
      contacts.push_back(k);
    } else {
      now_.approaches[*known].resize(now_.end - now_.first, -1);
    }
  }
  return now_;
}

/// Whether the contact of an impact approaches before an event at the same time that is not later.
bool SimultaneousImpacts::approaches_before(std::size_t impact, std::size_t event) {
  const auto known = now_.approaches.find(now_.contact_of[impact - now_.first]);
  signed char* remembered = known == now_.approaches.end() ? nullptr : &known->second[event - now_.first];
  if (remembered != nullptr && *remembered >= 0) return *remembered > 0;
  const Event& contact = (*asked_.said.events)[impact];
  Scene pair;
  pair.contact = Contact{contact.p_WC, contact.nhat_BA_W, Law::poisson, 0, 0};
  for (const auto& [body, after] : {std::pair(contact.a, &contact.after_a), std::pair(contact.b, &contact.after_b)}) {
    pair.bodies.push_back(asked_.scene.bodies[static_cast<std::size_t>(body)]);
    pair.bodies.back().X_WB = after->X_WB;
    pair.bodies.back().velocity = velocity_before(asked_, timeline_, body, event);
  }
  const bool answer = region_approaches(pair, envelope(asked_.scene), asked_.precision);
  if (remembered != nullptr) *remembered = answer ? 1 : 0;
  return answer;
}

/// Is a body of the impact that moves held by a contact in the segment that ends with this event?
bool SimultaneousImpacts::holds_before(std::size_t event, const Event& impact) const {
  const Event& first = (*asked_.said.events)[event];
  const auto is_held = [&](int body) {
    return body >= 0 && acts_on(impact, body) && !asked_.is_fixed(static_cast<std::size_t>(body)) &&
           !segment_before(timeline_, body, event).ballistic;
  };
  return is_held(first.a) || is_held(first.b);
}

bool SimultaneousImpacts::act_together_with(const Event& impact) {
  const std::vector<Event>& events = *asked_.said.events;
  const auto index = static_cast<std::size_t>(&impact - events.data());
  const auto moves = [&](int body) { return !asked_.is_fixed(static_cast<std::size_t>(body)); };
  const auto is_convex = [&](int body) {
    return !std::holds_alternative<Compound>(asked_.scene.bodies[static_cast<std::size_t>(body)].shape);
  };
  const Instant& instant = at(index);
  for (std::size_t k = instant.first; k < instant.end; ++k) {
    const Event& other = events[k];
    const bool shares = (moves(impact.a) && acts_on(other, impact.a)) || (moves(impact.b) && acts_on(other, impact.b));
    if (k == index || other.kind != Event::Kind::impact || !shares) continue;
    const bool same_pair = other.a == impact.a && other.b == impact.b;
    if (same_pair && !(is_convex(impact.a) && is_convex(impact.b))) return true;
    const std::size_t first = std::min(k, index);
    if (holds_before(first, impact)) return true;
    if (!same_pair && approaches_before(index, first) && approaches_before(k, first)) return true;
  }
  return false;
}

}  // namespace touchstone::properties
