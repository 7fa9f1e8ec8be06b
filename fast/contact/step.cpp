#include "fast/contact/step.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "fast/lin_canny/rotation.h"
#include "fast/motion/quaternion.h"
#include "fast/motion/steady_turn.h"

namespace touchstone::fast::contact {
namespace {

using constraint::Touch;
using constraint::Twist;

constexpr int most_rounds = 16;
constexpr int sweeps_to_stand = 2000;
constexpr int sweeps_of_a_round = 400;
constexpr double of_recovery = 0x1p-12;  // changes of velocity that are no greater do not matter
constexpr int calming_sweeps = 8;
constexpr double on_the_rim = 1 - 0x1p-20;

bool is_round(const motion::Flyer& flyer) { return flyer.I_BBcm_B == Mat3(flyer.I_BBcm_B(0, 0) * Mat3::Identity()); }

Mat3 inverse_inertia(const motion::Flyer& flyer) { return flyer.I_BBcm_B.inverse(); }

/// What is known of a body at the beginning of a step, and of its step so far.
struct Course {
  explicit Course(const Member& of) : member(&of), before(of.stance()), after(before) {
    w_B = before.R_WB.transpose() * of.state.velocity.w_WB;
    if (!of.is_fixed()) inverse_I = inverse_inertia(*of.flyer);
    mean_w_B = w_B;
  }

  /// The mean twist without contact forces, but for how the angular impulse of the last round turns with the body:
  /// I (W' − W) + h W̄ × I W̄ = (1 − h W̄×/2) R⁻¹ΔL in the body's axes.
  Twist free(double h) const {
    const Velocity& now = member->state.velocity;
    if (member->is_fixed()) return {now.v_WBcm, now.w_WB};
    const Vec3 v = now.v_WBcm + h / 2 * member->pull;
    if (is_round(*member->flyer)) return {v, now.w_WB};
    const Mat3& I = member->flyer->I_BBcm_B;
    const Vec3 turning = mean_w_B.cross(I * mean_w_B + gained_B / 2);
    return {v, before.R_WB * (w_B - h / 2 * (inverse_I * turning))};
  }

  /// Goes on with the mean twist; how far points come to stand from where they stood after the last round.
  double go(const Twist& mean, const Twist& free, double h) {
    const Stance was = after;
    if (member->is_fixed()) {
      turn = motion::steady_turn(mean.w, h).q;
    } else {
      turn = {1, h / 2 * mean.w.x(), h / 2 * mean.w.y(), h / 2 * mean.w.z()};
      mean_w_B = before.R_WB.transpose() * mean.w;
      gained_B = 2 * (member->flyer->I_BBcm_B * (before.R_WB.transpose() * (mean.w - free.w)));
    }
    q = motion::unit(motion::product(turn, member->state.X_WB.q_WB));
    after = {before.centre + h * mean.v, lin_canny::rotation(q)};
    return (after.centre - was.centre).norm() + member->flyer->radius * (after.R_WB - was.R_WB).norm();
  }

  State state(const Twist& mean) const {
    const Velocity& now = member->state.velocity;
    State state{{after.centre - after.R_WB * member->flyer->p_BBcm, q}, now};
    if (member->is_fixed()) return state;
    state.velocity.v_WBcm = 2 * mean.v - now.v_WBcm;
    state.velocity.w_WB =
        is_round(*member->flyer) ? Vec3(2 * mean.w - now.w_WB) : Vec3(after.R_WB * (2 * mean_w_B - w_B));
    return state;
  }

  const Member* member;
  Stance before, after;
  Mat3 inverse_I = Mat3::Zero();
  Vec3 w_B, mean_w_B, gained_B = Vec3::Zero();
  Quaternion turn, q;
};

/// A foot's row: normal and arms are the means of those before and after.
Touch row(const Hold& hold, const Nearness& before, const Nearness& after, const std::vector<Course>& bodies) {
  const Course &A = bodies[hold.a], &B = bodies[hold.b];
  Touch touch;
  touch.a = static_cast<int>(hold.a);
  touch.b = static_cast<int>(hold.b);
  touch.n = (before.nhat_BA_W + after.nhat_BA_W).normalized();
  touch.arm_A = ((before.p_WC - A.before.centre) + (after.p_WC - A.after.centre)) / 2;
  touch.arm_B = ((before.p_WC - B.before.centre) + (after.p_WC - B.after.centre)) / 2;
  touch.friction = hold.friction;
  return touch;
}

bool sticks(const Touch& touch) {
  const double P_n = touch.n.dot(touch.P);
  return (touch.P - P_n * touch.n).norm() < touch.friction * P_n * on_the_rim;
}

/// Each foot that pressed in turn loses its velocity along n, and across if it stuck. Of the block across n only the
/// greatest eigenvalue is known: less may be taken than is there, never more.
void calm(const std::vector<Touch>& at_end, const std::vector<Touch>& in_step,
          const std::vector<constraint::Mobility>& mobilities, std::vector<Twist>& twists) {
  for (int sweep = 0; sweep < calming_sweeps; ++sweep) {
    for (std::size_t i = 0; i < at_end.size(); ++i) {
      const Touch& touch = at_end[i];
      if (!(in_step[i].n.dot(in_step[i].P) > 0)) continue;
      const double u_n = touch.n.dot(relative_velocity(touch, twists));
      push(touch, -u_n / touch.K_nn * touch.n, mobilities, twists);
      if (!sticks(in_step[i])) continue;
      const Vec3 u = relative_velocity(touch, twists);
      push(touch, -(u - touch.n.dot(u) * touch.n) / touch.K_tt, mobilities, twists);
    }
  }
}

Twist twist(const State& state) { return {state.velocity.v_WBcm, state.velocity.w_WB}; }

void take_on(State& state, const Twist& twist) { state.velocity = {twist.v, twist.w}; }

/// The rows as the members stand.
std::vector<Touch> rows_at(const std::vector<Member>& members, const std::vector<Hold>& holds,
                           const std::vector<constraint::Mobility>& mobilities) {
  std::vector<Course> bodies;
  for (const Member& member : members) bodies.emplace_back(member);
  std::vector<Touch> touches;
  for (const Hold& hold : holds) {
    const Nearness near = nearness(hold.foot.a, bodies[hold.a].before, hold.foot.b, bodies[hold.b].before, hold.about);
    touches.push_back(row(hold, near, near, bodies));
    prepare(touches.back(), mobilities);
  }
  return touches;
}

std::vector<constraint::Mobility> mobilities_of(const std::vector<Member>& members) {
  std::vector<constraint::Mobility> all;
  for (const Member& member : members) all.push_back(member.mobility());
  return all;
}

}  // namespace

Stance Member::stance() const {
  const Mat3 R = lin_canny::rotation(state.X_WB.q_WB);
  return {state.X_WB.p_WB + R * flyer->p_BBcm, R};
}

constraint::Mobility Member::mobility() const {
  if (is_fixed()) return {};
  if (is_round(*flyer)) return {1 / flyer->mass, inverse_inertia(*flyer)};
  const Mat3 R = lin_canny::rotation(state.X_WB.q_WB);
  return {1 / flyer->mass, R * inverse_inertia(*flyer) * R.transpose()};
}

Stepped step(const std::vector<Member>& members, std::vector<Hold>& holds, double h, double tolerance,
             double recovery) {
  std::vector<Course> bodies;
  std::vector<constraint::Mobility> mobilities = mobilities_of(members);
  std::vector<Twist> mean;
  for (const Member& member : members) {
    Course& body = bodies.emplace_back(member);
    mean.push_back(twist(member.state));
    body.go(mean.back(), mean.back(), h);
  }
  std::vector<Nearness> before;
  std::vector<double> least_u_n;
  for (const Hold& hold : holds) {
    before.push_back(nearness(hold.foot.a, bodies[hold.a].before, hold.foot.b, bodies[hold.b].before, hold.about));
    least_u_n.push_back(std::min(-before.back().gap / h, recovery));
  }
  std::vector<Touch> touches(holds.size());
  std::vector<double> missed(holds.size(), 0.0);  // m; of the gap, by the curves that features describe
  double change = 0;
  for (int round = 0; round < most_rounds; ++round) {
    for (std::size_t i = 0; i < holds.size(); ++i) {
      const Hold& hold = holds[i];
      const Nearness after =
          nearness(hold.foot.a, bodies[hold.a].after, hold.foot.b, bodies[hold.b].after, before[i].nhat_BA_W);
      const double over = after.gap - (before[i].gap + h * least_u_n[i]);
      if (round > 1 && (over < 0 || !touches[i].P.isZero(0))) missed[i] += over;
      const Vec3 guess = round > 0 ? touches[i].P : hold.foot.P_A_W;
      touches[i] = row(hold, before[i], after, bodies);
      touches[i].P = guess;
      touches[i].least_u_n = least_u_n[i] - missed[i] / h;
      prepare(touches[i], mobilities);
    }
    std::vector<Twist> free;
    for (const Course& body : bodies) free.push_back(body.free(h));
    mean = free;
    solve(touches, mobilities, mean,
          {.sweeps = sweeps_of_a_round,
           .sweeps_to_a_jump = 64,
           .most_that_jump = 16,
           .enough = std::min(tolerance / h, of_recovery * recovery)});
    const double changed = change;
    change = 0;
    for (std::size_t i = 0; i < bodies.size(); ++i) change = std::max(change, bodies[i].go(mean[i], free[i], h));
    if (change <= tolerance || (round > 2 && change > changed / 2)) break;  // or as near as the sweeps come
  }
  std::vector<Member> moved = members;
  std::vector<Twist> twists;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    moved[i].state = bodies[i].state(mean[i]);
    twists.push_back(twist(moved[i].state));
  }
  for (std::size_t i = 0; i < holds.size(); ++i) holds[i].foot.P_A_W = touches[i].P;
  mobilities = mobilities_of(moved);
  calm(rows_at(moved, holds, mobilities), touches, mobilities, twists);
  Stepped stepped;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (!moved[i].is_fixed()) take_on(moved[i].state, twists[i]);
    stepped.after.push_back(moved[i].state);
  }
  stepped.mean = std::move(mean);
  return stepped;
}

double unbalanced(const std::vector<Member>& members, std::vector<Hold>& holds) {
  const std::vector<constraint::Mobility> mobilities = mobilities_of(members);
  std::vector<Touch> touches = rows_at(members, holds, mobilities);
  std::vector<Twist> left(members.size());
  double greatest = 0, most = 0;
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (members[i].is_fixed()) continue;
    left[i].v = members[i].pull;
    greatest = std::max(greatest, members[i].pull.norm());
  }
  solve(touches, mobilities, left, {.sweeps = sweeps_to_stand});
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (!members[i].is_fixed()) most = std::max(most, left[i].v.norm() + members[i].flyer->radius * left[i].w.norm());
  }
  for (std::size_t i = 0; i < holds.size(); ++i) holds[i].foot.P_A_W = touches[i].P;
  return most / greatest;
}

void land(std::vector<Member>& members, const std::vector<Hold>& holds) {
  const std::vector<constraint::Mobility> mobilities = mobilities_of(members);
  std::vector<Touch> touches = rows_at(members, holds, mobilities);
  std::vector<Twist> twists;
  for (const Member& member : members) twists.push_back(twist(member.state));
  solve(touches, mobilities, twists, {});
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (!members[i].is_fixed()) take_on(members[i].state, twists[i]);
  }
}

}  // namespace touchstone::fast::contact
