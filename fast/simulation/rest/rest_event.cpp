#include "fast/simulation/rest/rest_event.h"

#include <algorithm>

#include "fast/contact/patch.h"
#include "fast/mark.h"
#include "fast/simulation/trajectory.h"

namespace touchstone::fast::simulation {
namespace {

/// An event of a body, which rests, and its support; P acts on the first of the two.
Event rest_event(const Run& run, Event::Kind kind, BodyId id, const State& state, const Vec3& P_A_W) {
  const RestingContact& rest = *run.rests.of(id);
  const State support = run.world.body(rest.on).state(run.world.now());
  const bool first = id < rest.on;
  return {kind,
          run.world.now(),
          static_cast<int>(std::min(id, rest.on)),
          static_cast<int>(std::max(id, rest.on)),
          state.X_WB.p_WB + (P_A_W.isZero(0) ? rest.touch : rest.lever),
          first ? rest.nhat_W : -rest.nhat_W,
          P_A_W,
          first ? state : support,
          first ? support : state};
}

/// Records that a resting contact begins or changes. The impulse since then is the change of momentum that the applied
/// accelerations do not explain.
void record_contact(Run& run, Event::Kind kind, BodyId id, const Vec3& v_before, double since) {
  const BodyMotion& body = run.world.body(id);
  const double now = run.world.now();
  const State state = body.state(now);
  const Vec3 P = (state.velocity.v_WBcm - v_before - (now - since) * run.world.acceleration(id)) / body.inverse_mass();
  run.recorder.record(rest_event(run, kind, id, state, id < run.rests.of(id)->on ? P : -P));
}

/// The body's velocity when the law of the resting contact began. Its first micro-bounce may just have begun.
Vec3 v_before(const RestingContact& rest) { return rest.start.velocity.v_WBcm + rest.bounces.speed * rest.nhat_W; }

/// Whether the law of the resting contact sums up micro-bounces.
bool are_under_way(const RestingContact& rest) { return rest.bounces_end > rest.since; }

/// Sets the body's trajectory in the resting contact.
void set_rest(Run& run, const RestCandidate& candidate, RestingContact rest, const MicroBounces& bounces,
              double bounces_end) {
  const double now = run.world.now();
  if (bounces_end > now && bounces_end <= rest.until) {
    rest.until = bounces_end;
    rest.ends_by = RestingContact::End::bounces_end;
  }
  rest.on = candidate.on;
  rest.since = now;
  rest.bounces = bounces;
  rest.bounces_end = bounces_end;
  const RestingContact* before = run.rests.of(candidate.id);
  if (before && before->on != candidate.on) release_rest(run, candidate.id, candidate.state);
  run.world.body(candidate.id).restart(now, rest.start, rest.acceleration, rest.alpha);
  keep_orientation(run, candidate.id);
  run.schedule.trajectory_changed(candidate.id);
  run.rests.set(candidate.id, rest);
  run.schedule.predict_all(candidate.id);
}

/// The same, if there is a closed form. Returns false if there is none.
bool try_set_rest(Run& run, const RestCandidate& candidate, const MicroBounces& bounces, double bounces_end) {
  const std::optional<RestingContact> rest = closed_form_rest(run.world, candidate, bounces.load);
  if (rest) set_rest(run, candidate, *rest, bounces, bounces_end);
  return rest.has_value();
}

}  // namespace

std::optional<RestCandidate> rest_candidate(const World& world, BodyId a, BodyId b, const Touch& touch) {
  const bool first = world.body(b).fixed();
  if (world.body(a).fixed() == first) return {};
  RestCandidate candidate{first ? a : b, first ? b : a, first ? touch.nhat_BA_W : Vec3(-touch.nhat_BA_W), {}};
  const BodyMotion& on = world.body(candidate.on);
  if (on.kind() == Kind::block) candidate.nhat_W = face_normal(on, candidate.nhat_W);
  candidate.state = without_normal(on, world.body(candidate.id).state(world.now()), candidate.nhat_W);
  return candidate;
}

std::optional<RestingContact> closed_form_rest(const World& world, const RestCandidate& candidate, double load) {
  const BodyMotion &body = world.body(candidate.id), &on = world.body(candidate.on);
  if (on.kind() != Kind::block) return {};
  const double friction = world.coefficients(candidate.id, candidate.on).friction, now = world.now();
  const Vec3& acceleration = world.acceleration(candidate.id);
  if (is_pulled_off(candidate.nhat_W, acceleration)) return {};
  if (body.kind() == Kind::ball) {
    return ball_on_face(body, on, candidate.state, now, candidate.nhat_W, acceleration, friction, load);
  }
  const double rest_speed = 4 * micro_bounce_speed(-candidate.nhat_W.dot(acceleration), world.envelope());
  const lin_canny::CachedPose at_body(body.ballistic().pose(now)), at_on(on.ballistic().pose(now));
  const std::vector<Vec3> corners = contact::patch(body.model().solid, at_body, on.model().solid, at_on,
                                                   candidate.nhat_W, body.path().place(now), world.envelope());
  return body_on_face(body, on, candidate.state, now, candidate.nhat_W, corners, acceleration, friction, rest_speed,
                      load);
}

void start_rest(Run& run, const RestCandidate& candidate, const RestingContact& rest, const Vec3& v_before) {
  const double now = run.world.now();
  set_rest(run, candidate, rest, {}, now);
  record_contact(run, Event::Kind::contact, candidate.id, v_before, now);
}

bool try_rest(Run& run, const RestCandidate& candidate, const Vec3& v_before, const MicroBounces& bounces,
              double until) {
  const double now = run.world.now();
  if (!try_set_rest(run, candidate, until > now ? bounces : MicroBounces{}, until)) return false;
  if (until <= now) record_contact(run, Event::Kind::contact, candidate.id, v_before, now);
  return true;
}

void end_rest_phase(Run& run, BodyId id) {
  mark(Mark::rest_phase);
  const RestingContact was = *run.rests.of(id);
  const BodyMotion &body = run.world.body(id), &on = run.world.body(was.on);
  const double now = run.world.now();
  State state = without_normal(on, body.state(now), was.nhat_W);
  if (was.ends_by == RestingContact::End::slip_ends) state = without_slip(body, on, state, was.nhat_W);
  const bool bounces_on = was.bounces_end > now;
  if (was.ends_by != RestingContact::End::leaves &&
      try_set_rest(run, {id, was.on, was.nhat_W, state},
                   bounces_on ? MicroBounces{0, was.bounces.load} : MicroBounces{}, was.bounces_end)) {
    return record_contact(run, are_under_way(was) ? Event::Kind::completed : Event::Kind::contact, id, v_before(was),
                          was.since);
  }
  release_rest(run, id, state);
  set_trajectory(run, id, state);
  run.schedule.predict_all(id);
}

void sum_up_bounces(Run& run, BodyId id) {
  const RestingContact* rest = run.rests.of(id);
  if (!rest || !are_under_way(*rest)) return;
  record_contact(run, Event::Kind::completed, id, v_before(*rest), rest->since);
  RestingContact summed_up = *rest;
  summed_up.bounces_end = summed_up.since;
  run.rests.set(id, summed_up);
}

void release_rest(Run& run, BodyId id, const State& state) {
  sum_up_bounces(run, id);
  run.recorder.record(rest_event(run, Event::Kind::release, id, state, Vec3::Zero()));
  run.rests.erase(id);
}

}  // namespace touchstone::fast::simulation
