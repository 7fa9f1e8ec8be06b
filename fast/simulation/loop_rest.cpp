// The part of the loop that is about rest: who lies on whom, until when, and what comes then.
#include <algorithm>

#include "fast/simulation/loop.h"

namespace touchstone::fast::world {

/// The one of the pair that may rest on the other, and that other; nobody if both move or none does.
std::optional<Loop::Laid> Loop::laid(const Due& due, const Touch& touch) const {
  const bool first = bodies_[due.b].fixed();
  if (bodies_[due.a].fixed() == first) return {};
  Laid laid{first ? due.a : due.b, first ? due.b : due.a, first ? touch.nhat_BA_W : Vec3(-touch.nhat_BA_W), {}};
  if (bodies_[laid.on].kind() == Kind::block) laid.nhat_W = face_normal(bodies_[laid.on], laid.nhat_W);
  laid.state = without_normal(bodies_[laid.on], bodies_[laid.id].state(now_), laid.nhat_W);
  return laid;
}

std::optional<Rest> Loop::rest_of(const Laid& laid, double load) const {
  const Mover &body = bodies_[laid.id], &on = bodies_[laid.on];
  if (on.kind() != Kind::block) return {};
  const double friction = coefficients(body, on, scene_->flight->law).friction;
  if (body.kind() == Kind::ball) {
    return roll(body, on, laid.state, now_, laid.nhat_W, pull_[laid.id], friction, load);
  }
  const double still = 4 * least_speed(-laid.nhat_W.dot(pull_[laid.id]), envelope_);
  const std::vector<Vec3> corners = patch(body, on, now_, laid.nhat_W, body.path().place(now_), envelope_);
  return lie(body, on, laid.state, now_, laid.nhat_W, corners, pull_[laid.id], friction, still);
}

bool Loop::can_rest(const Due& due, const Touch& touch) const {
  const std::optional<Laid> found = laid(due, touch);
  return found && rest_of(*found, 1);
}

/// From now on the one rests on the other, if there is a closed form; hops that are left end at `until`.
bool Loop::hold(const Due& due, const Touch& touch, const Hops& hops, double until) {
  const std::optional<Laid> found = laid(due, touch);
  if (!found) return false;
  const Vec3 v_before = bodies_[found->id].path().velocity(now_);
  if (!lay(*found, until > now_ ? hops : Hops{}, until)) return false;
  if (until <= now_) record_contact(Event::Kind::contact, found->id, v_before, now_);
  return true;
}

/// The body's path while it rests; false where there is no closed form.
bool Loop::lay(const Laid& laid, const Hops& hops, double hops_end) {
  std::optional<Rest> rest = rest_of(laid, hops.load);
  if (!rest) return false;
  if (hops_end > now_ && hops_end <= rest->until) {
    rest->until = hops_end;
    rest->then = Rest::Then::hops_end;
  }
  rest->on = laid.on;
  rest->hops = hops;
  rest->hops_end = hops_end;
  if (rest_[laid.id] && rest_[laid.id]->on != laid.on) release(laid.id, laid.state);
  bodies_[laid.id].fly(now_, rest->start, rest->acceleration, rest->alpha);
  heap_.drop(laid.id);
  file(laid.id);
  rest_[laid.id] = rest;
  watch_all(laid.id, laid.id);
  return true;
}

/// A rest comes to its next change: the hops before it are over, slip ends, or the foot leaves the face.
void Loop::change(BodyId id) {
  const Rest was = *rest_[id];
  const Vec3 v_before = bodies_[id].path().v + was.hops.speed * was.nhat_W;
  const double since = bodies_[id].path().since;
  State state = without_normal(bodies_[was.on], bodies_[id].state(now_), was.nhat_W);
  if (was.then == Rest::Then::slip_ends) state = without_slip(bodies_[id], bodies_[was.on], state, was.nhat_W);
  const bool hops_on = was.hops_end > now_;
  if (was.then != Rest::Then::leaves &&
      lay({id, was.on, was.nhat_W, state}, hops_on ? Hops{0, was.hops.load} : Hops{}, was.hops_end)) {
    return record_contact(was.then == Rest::Then::hops_end ? Event::Kind::completed : Event::Kind::contact, id,
                          v_before, since);
  }
  release(id, state);
  set_out(id, state);
  watch_all(id, id);
}

/// A rest begins or changes. Its impulse since then: what the body gained beyond what gravity gave.
void Loop::record_contact(Event::Kind kind, BodyId id, const Vec3& v_before, double since) {
  const Rest& rest = *rest_[id];
  const State state = bodies_[id].state(now_), support = bodies_[rest.on].state(now_);
  const Vec3 P = (state.velocity.v_WBcm - v_before - (now_ - since) * pull_[id]) / bodies_[id].inverse_mass();
  const Vec3 C = state.X_WB.p_WB + rest.lever;
  const bool first = id < rest.on;
  record({kind, now_, static_cast<int>(std::min(id, rest.on)), static_cast<int>(std::max(id, rest.on)), C,
          first ? rest.nhat_W : -rest.nhat_W, first ? P : -P, first ? state : support, first ? support : state});
}

void Loop::release(BodyId id, const State& state) {
  const Rest& rest = *rest_[id];
  const State support = bodies_[rest.on].state(now_);
  const bool first = id < rest.on;
  record({Event::Kind::release, now_, static_cast<int>(std::min(id, rest.on)), static_cast<int>(std::max(id, rest.on)),
          state.X_WB.p_WB + rest.lever, first ? rest.nhat_W : -rest.nhat_W, Vec3::Zero(), first ? state : support,
          first ? support : state});
  rest_[id].reset();
}

}  // namespace touchstone::fast::world
