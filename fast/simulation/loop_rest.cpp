// The part of the loop that handles resting contacts with closed forms.
#include <algorithm>

#include "fast/simulation/loop.h"

namespace touchstone::fast::world {

/// The body of the pair that may rest on the other one. None unless exactly one of them is fixed.
std::optional<Loop::RestCandidate> Loop::rest_candidate(const PairEvent& pair_event, const Touch& touch) const {
  const bool first = bodies_[pair_event.b].fixed();
  if (bodies_[pair_event.a].fixed() == first) return {};
  RestCandidate candidate{first ? pair_event.a : pair_event.b,
                          first ? pair_event.b : pair_event.a,
                          first ? touch.nhat_BA_W : Vec3(-touch.nhat_BA_W),
                          {}};
  if (bodies_[candidate.on].kind() == Kind::block)
    candidate.nhat_W = face_normal(bodies_[candidate.on], candidate.nhat_W);
  candidate.state = without_normal(bodies_[candidate.on], bodies_[candidate.id].state(now_), candidate.nhat_W);
  return candidate;
}

std::optional<RestingContact> Loop::closed_form_rest(const RestCandidate& candidate, double load) const {
  const BodyMotion &body = bodies_[candidate.id], &on = bodies_[candidate.on];
  if (on.kind() != Kind::block) return {};
  const double friction = coefficients(body, on, scene_->motion->law).friction;
  if (body.kind() == Kind::ball) {
    return ball_on_face(body, on, candidate.state, now_, candidate.nhat_W, acceleration_[candidate.id], friction, load);
  }
  const double rest_speed = 4 * micro_bounce_speed(-candidate.nhat_W.dot(acceleration_[candidate.id]), envelope_);
  const std::vector<Vec3> corners = patch(body, on, now_, candidate.nhat_W, body.path().place(now_), envelope_);
  return body_on_face(body, on, candidate.state, now_, candidate.nhat_W, corners, acceleration_[candidate.id], friction,
                      rest_speed);
}

bool Loop::can_rest(const PairEvent& pair_event, const Touch& touch) const {
  const std::optional<RestCandidate> found = rest_candidate(pair_event, touch);
  return found && closed_form_rest(*found, 1);
}

/// Starts a resting contact, if it has a closed form. The remaining micro-bounces end at `until`.
bool Loop::try_rest(const PairEvent& pair_event, const Touch& touch, const MicroBounces& bounces, double until) {
  const std::optional<RestCandidate> found = rest_candidate(pair_event, touch);
  if (!found) return false;
  const Vec3 v_before = bodies_[found->id].path().velocity(now_);
  if (!start_rest(*found, until > now_ ? bounces : MicroBounces{}, until)) return false;
  if (until <= now_) record_contact(Event::Kind::contact, found->id, v_before, now_);
  return true;
}

/// Sets the body's trajectory in the resting contact. Returns false if there is no closed form.
bool Loop::start_rest(const RestCandidate& candidate, const MicroBounces& bounces, double bounces_end) {
  std::optional<RestingContact> rest = closed_form_rest(candidate, bounces.load);
  if (!rest) return false;
  if (bounces_end > now_ && bounces_end <= rest->until) {
    rest->until = bounces_end;
    rest->ends_by = RestingContact::End::bounces_end;
  }
  rest->on = candidate.on;
  rest->bounces = bounces;
  rest->bounces_end = bounces_end;
  if (rest_[candidate.id] && rest_[candidate.id]->on != candidate.on) release(candidate.id, candidate.state);
  bodies_[candidate.id].restart(now_, rest->start, rest->acceleration, rest->alpha);
  queue_.drop(candidate.id);
  update_proxy(candidate.id);
  rest_[candidate.id] = rest;
  schedule_all(candidate.id, candidate.id);
  return true;
}

/// A resting contact ends or changes: its micro-bounces are over, slip ends, or the contact point leaves the face.
void Loop::end_rest_phase(BodyId id) {
  const RestingContact was = *rest_[id];
  const Vec3 v_before = bodies_[id].path().v + was.bounces.speed * was.nhat_W;
  const double since = bodies_[id].path().since;
  State state = without_normal(bodies_[was.on], bodies_[id].state(now_), was.nhat_W);
  if (was.ends_by == RestingContact::End::slip_ends)
    state = without_slip(bodies_[id], bodies_[was.on], state, was.nhat_W);
  const bool bounces_on = was.bounces_end > now_;
  if (was.ends_by != RestingContact::End::leaves &&
      start_rest({id, was.on, was.nhat_W, state}, bounces_on ? MicroBounces{0, was.bounces.load} : MicroBounces{},
                 was.bounces_end)) {
    return record_contact(
        was.ends_by == RestingContact::End::bounces_end ? Event::Kind::completed : Event::Kind::contact, id, v_before,
        since);
  }
  release(id, state);
  set_trajectory(id, state);
  schedule_all(id, id);
}

/// Records that a resting contact begins or changes. The impulse since then is the change of momentum that the applied
/// accelerations do not explain.
void Loop::record_contact(Event::Kind kind, BodyId id, const Vec3& v_before, double since) {
  const RestingContact& rest = *rest_[id];
  const State state = bodies_[id].state(now_), support = bodies_[rest.on].state(now_);
  const Vec3 P = (state.velocity.v_WBcm - v_before - (now_ - since) * acceleration_[id]) / bodies_[id].inverse_mass();
  const Vec3 C = state.X_WB.p_WB + rest.lever;
  const bool first = id < rest.on;
  record({kind, now_, static_cast<int>(std::min(id, rest.on)), static_cast<int>(std::max(id, rest.on)), C,
          first ? rest.nhat_W : -rest.nhat_W, first ? P : -P, first ? state : support, first ? support : state});
}

void Loop::release(BodyId id, const State& state) {
  const RestingContact& rest = *rest_[id];
  const State support = bodies_[rest.on].state(now_);
  const bool first = id < rest.on;
  record({Event::Kind::release, now_, static_cast<int>(std::min(id, rest.on)), static_cast<int>(std::max(id, rest.on)),
          state.X_WB.p_WB + rest.lever, first ? rest.nhat_W : -rest.nhat_W, Vec3::Zero(), first ? state : support,
          first ? support : state});
  rest_[id].reset();
}

}  // namespace touchstone::fast::world
