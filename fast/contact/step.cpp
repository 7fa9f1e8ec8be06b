#include "fast/contact/step.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "fast/contact/combined_solver.h"
#include "fast/contact/sparse/balance.h"
#include "fast/lin_canny/rotation.h"
#include "fast/mark.h"
#include "fast/motion/quaternion.h"
#include "fast/motion/steady_turn.h"
#include "model/infinity.h"

namespace touchstone::fast::contact {
namespace {

constexpr int most_rounds = 16;
constexpr int first_corrected = 2;  // round: its rows know by how much the last one missed the gaps
constexpr int sweeps_of_a_round = 400;
constexpr double of_recovery = 0x1p-10;  // of `recovery`: smaller changes of velocity count as converged
constexpr int projection_sweeps = 8;
constexpr double negligible_miss = 0x1p8;  // times the tolerance: how much curves may change a gap

bool is_round(const motion::RigidBodyModel& model) {
  return model.I_BBcm_B == Mat3(model.I_BBcm_B(0, 0) * Mat3::Identity());
}

/// Its orientation changes no contact, so that it need not turn by Cayley's map.
bool is_centred_ball(const motion::RigidBodyModel& model) {
  return std::holds_alternative<Sphere>(model.shape) && model.p_BBcm.isZero(0) && is_round(model);
}

Mat3 inverse_inertia(const motion::RigidBodyModel& model) { return model.I_BBcm_B.inverse(); }

/// A body at the beginning of a step, and its pose after the step as of the last iteration.
struct BodyStep {
  explicit BodyStep(const StepBody& of) : step_body(&of), before(of.transform()), after(before) {
    w_B = before.R_WB.transpose() * of.state.velocity.w_WB;
    if (!of.is_fixed()) inverse_I = inverse_inertia(*of.model);
    mean_w_B = w_B;
  }

  /// The mean twist without contact forces, corrected for the rotation of the last iteration's angular impulse with the
  /// body: I (W' − W) + h W̄ × I W̄ = (1 − h W̄×/2) R⁻¹ΔL in the body's axes.
  Twist free(double h) const {
    const Velocity& now = step_body->state.velocity;
    if (step_body->is_fixed()) return {now.v_WBcm, now.w_WB};
    const Vec3 v = now.v_WBcm + h / 2 * step_body->acceleration;
    if (is_round(*step_body->model)) return {v, now.w_WB};
    const Mat3& I = step_body->model->I_BBcm_B;
    const Vec3 turning = mean_w_B.cross(I * mean_w_B + gained_B / 2);
    return {v, before.R_WB * (w_B - h / 2 * (inverse_I * turning))};
  }

  /// Moves the body with the mean twist. Returns a bound on how far its points moved since the last iteration.
  double go(const Twist& mean, const Twist& free, double h) {
    const RigidTransform was = after;
    const bool spins_freely = is_round(*step_body->model) && mean.w == step_body->state.velocity.w_WB;
    if (step_body->is_fixed() || spins_freely || is_centred_ball(*step_body->model)) {
      turn = motion::steady_turn(mean.w, h).q;
    } else {
      turn = {1, h / 2 * mean.w.x(), h / 2 * mean.w.y(), h / 2 * mean.w.z()};
      mean_w_B = before.R_WB.transpose() * mean.w;
      gained_B = 2 * (step_body->model->I_BBcm_B * (before.R_WB.transpose() * (mean.w - free.w)));
    }
    q = motion::unit(motion::product(turn, step_body->state.X_WB.q_WB));
    after = {before.centre + h * mean.v, lin_canny::rotation(q)};
    return (after.centre - was.centre).norm() + step_body->model->radius * (after.R_WB - was.R_WB).norm();
  }

  double radius() const { return step_body->is_fixed() ? infinity : step_body->model->radius; }

  State state(const Twist& mean) const {
    const Velocity& now = step_body->state.velocity;
    State state{{after.centre - after.R_WB * step_body->model->p_BBcm, q}, now};
    if (step_body->is_fixed()) return state;
    state.velocity.v_WBcm = 2 * mean.v - now.v_WBcm;
    state.velocity.w_WB =
        is_round(*step_body->model) ? Vec3(2 * mean.w - now.w_WB) : Vec3(after.R_WB * (2 * mean_w_B - w_B));
    return state;
  }

  const StepBody* step_body;
  RigidTransform before, after;
  Mat3 inverse_I = Mat3::Zero();
  Vec3 w_B, mean_w_B, gained_B = Vec3::Zero();
  Quaternion turn, q;
};

Nearness nearness_of(const ContactConstraint& constraint, const RigidTransform& A, const RigidTransform& B,
                     const Vec3& about) {
  return nearness(constraint.contact_point.a, A, constraint.contact_point.b, B, about);
}

/// Half the impulse of a step of h, if its forces are those of the last step. Forces of a shorter step are not expected
/// to last longer than they did: they may be those of an impact.
Vec3 expected_impulse(const ContactPoint& contact_point, double h) {
  return std::min(h, contact_point.h) / 2 * contact_point.F_A_W;
}

/// The contact's row for the solver: normal and arms are the means of those before and after.
ContactRow row_of(const ContactConstraint& constraint, const Nearness& before, const Nearness& after,
                  const std::vector<BodyStep>& bodies) {
  const BodyStep &A = bodies[constraint.a], &B = bodies[constraint.b];
  ContactRow row;
  row.a = static_cast<int>(constraint.a);
  row.b = static_cast<int>(constraint.b);
  row.n = (before.nhat_BA_W + after.nhat_BA_W).normalized();
  row.arm_A = ((before.p_WC - A.before.centre) + (after.p_WC - A.after.centre)) / 2;
  row.arm_B = ((before.p_WC - B.before.centre) + (after.p_WC - B.after.centre)) / 2;
  row.friction = constraint.friction;
  return row;
}

/// Edges and balls move past each other along curves, so in a step of h a gap grows by `missed` (m) more than by h u_n.
/// Where that is not negligible, the contact point is moved sideways until u_n is right: then the work of the contact
/// is P·u, as with a discrete gradient, so the step adds no energy (Gonzalez 1996). Where it is negligible, or the
/// point would move by more than of second order in h, or would turn a smooth ball, the row's bound is changed instead.
void follow_curve(ContactRow& row, double missed, double negligible, double h, const std::vector<Twist>& mean,
                  const std::vector<BodyStep>& bodies) {
  const Vec3 across = row.n.cross(mean[index(row.a)].w - mean[index(row.b)].w);
  const Vec3 shift = missed / h / across.squaredNorm() * across;
  const double radius = std::min(bodies[index(row.a)].radius(), bodies[index(row.b)].radius());
  const bool is_small = shift.norm() <= radius * h * across.norm();
  if (std::abs(missed) > negligible && row.friction > 0 && is_small) {
    row.arm_A += shift;
    row.arm_B += shift;
  } else {
    row.least_u_n -= missed / h;
  }
}

/// How much an impulse P changes u.
Vec3 response(const ContactRow& row, const Vec3& P, const std::vector<Mobility>& mobilities) {
  const Mobility &A = mobilities[index(row.a)], &B = mobilities[index(row.b)];
  return (A.inverse_mass + B.inverse_mass) * P + (A.inverse_inertia * row.arm_A.cross(P)).cross(row.arm_A) +
         (B.inverse_inertia * row.arm_B.cross(P)).cross(row.arm_B);
}

void remove_normal_velocity(const ContactRow& row, const std::vector<Mobility>& mobilities,
                            std::vector<Twist>& twists) {
  const double u_n = row.n.dot(relative_velocity(row, twists));
  apply_impulse(row, -u_n / row.K_nn * row.n, mobilities, twists);
}

/// Removes the normal velocity of a contact that slips, by an impulse with friction: that of the step belongs to the
/// step's normal impulse alone. Less normal impulse means less friction, so this may add energy, but no more than is
/// left of `work` (J), which friction took in the step; otherwise the impulse is along the normal.
void project_slip(const ContactRow& row, const Vec3& friction_per_normal, double& work,
                  const std::vector<Mobility>& mobilities, std::vector<Twist>& twists) {
  const Vec3 u = relative_velocity(row, twists), along = row.n + friction_per_normal;
  const Vec3 change = response(row, along, mobilities);
  const double impulse = -row.n.dot(u) / row.n.dot(change);
  const double added = impulse * along.dot(u + impulse / 2 * change);
  if (!friction_per_normal.isZero(0) && row.n.dot(change) > row.K_nn / 4 && added <= work) {
    work -= std::max(0.0, added);
    apply_impulse(row, impulse * along, mobilities, twists);
  } else {
    remove_normal_velocity(row, mobilities, twists);
  }
}

/// What the end of a step does to a contact that pressed in it.
struct AtEnd {
  const ContactRow* row = nullptr;
  bool sticks = false;
  Vec3 friction_per_normal = Vec3::Zero();
  double work = 0;  ///< J, that friction took in the step
};

/// A contact sticks at the end if it stuck in the mean, or if it slips along its friction then: so slip ended in the
/// step, and friction would go on to reverse it.
AtEnd at_end_of(const ContactRow& at_end, const ContactRow& in_step, const std::vector<Twist>& mean,
                const std::vector<Twist>& twists) {
  const double P_n = in_step.n.dot(in_step.P);
  const Vec3 P_t = in_step.P - P_n * in_step.n;
  const bool has_friction = P_t.norm() > in_step.friction * P_n / 2 && in_step.friction > 0;  // not rounding alone
  const bool is_reversed = has_friction && P_t.dot(relative_velocity(at_end, twists)) > 0;
  return {&at_end, sticks(in_step) || is_reversed, P_t / P_n, -2 * P_t.dot(relative_velocity(in_step, mean))};
}

/// For each contact that pressed, in turn: removes its normal velocity, and its tangential velocity if it sticks. That
/// uses the largest eigenvalue of K_tt, so the tangential impulse is under-corrected and never adds energy.
void project_velocities(const std::vector<ContactRow>& at_end, const std::vector<ContactRow>& in_step,
                        const std::vector<Twist>& mean, const std::vector<Mobility>& mobilities,
                        std::vector<Twist>& twists) {
  std::vector<AtEnd> contacts;
  for (std::size_t i = 0; i < in_step.size(); ++i) {
    if (in_step[i].n.dot(in_step[i].P) > 0) contacts.push_back(at_end_of(at_end[i], in_step[i], mean, twists));
  }
  for (int sweep = 0; sweep < projection_sweeps; ++sweep) {
    for (AtEnd& contact : contacts) {
      const ContactRow& row = *contact.row;
      if (!contact.sticks) {
        project_slip(row, contact.friction_per_normal, contact.work, mobilities, twists);
        continue;
      }
      remove_normal_velocity(row, mobilities, twists);
      const Vec3 u = relative_velocity(row, twists);
      apply_impulse(row, -(u - row.n.dot(u) * row.n) / row.K_tt, mobilities, twists);
    }
  }
}

/// See step.h. `rows`: of the last round, in which least_u_n was corrected for the curves of the features.
double residual_of_step(const std::vector<ContactConstraint>& constraints, const std::vector<BodyStep>& bodies,
                        const std::vector<Nearness>& before, const std::vector<double>& least_u_n,
                        std::vector<ContactRow> rows, const std::vector<Twist>& mean, double h) {
  double greatest = 0;
  for (std::size_t i = 0; i < constraints.size(); ++i) {
    const ContactConstraint& constraint = constraints[i];
    const Nearness after =
        nearness_of(constraint, bodies[constraint.a].after, bodies[constraint.b].after, before[i].nhat_BA_W);
    ContactRow& row = rows[i];
    row.least_u_n = least_u_n[i];
    const Vec3 u = relative_velocity(row, mean);
    const double u_n = (after.gap - before[i].gap) / h;
    greatest = std::max(greatest, h * residual(row, u + (u_n - row.n.dot(u)) * row.n));
  }
  return greatest;
}

Twist twist(const State& state) { return {state.velocity.v_WBcm, state.velocity.w_WB}; }

void set_velocity(State& state, const Twist& twist) { state.velocity = {twist.v, twist.w}; }

/// The rows at the bodies' current states.
std::vector<ContactRow> rows_at(const std::vector<StepBody>& step_bodies,
                                const std::vector<ContactConstraint>& constraints,
                                const std::vector<Mobility>& mobilities) {
  std::vector<BodyStep> bodies;
  for (const StepBody& step_body : step_bodies) bodies.emplace_back(step_body);
  std::vector<ContactRow> rows;
  for (const ContactConstraint& constraint : constraints) {
    const Nearness near =
        nearness_of(constraint, bodies[constraint.a].before, bodies[constraint.b].before, constraint.about);
    rows.push_back(row_of(constraint, near, near, bodies));
    prepare(rows.back(), mobilities);
  }
  return rows;
}

/// Of each contact, before the projection. `rows`: of the step.
std::vector<Slip> slips_of(const std::vector<BodyStep>& bodies, const std::vector<Nearness>& before,
                           const std::vector<ContactRow>& rows, const std::vector<ContactRow>& at_end,
                           const std::vector<Twist>& twists) {
  std::vector<Slip> slips;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const BodyStep &A = bodies[index(rows[i].a)], &B = bodies[index(rows[i].b)];
    const auto velocity = [&](const BodyStep& body) {
      const Velocity& V = body.step_body->state.velocity;
      return Vec3(V.v_WBcm + V.w_WB.cross(before[i].p_WC - body.before.centre));
    };
    const Vec3 u = velocity(A) - velocity(B), &n = before[i].nhat_BA_W, u_t = u - n.dot(u) * n;
    const double speed = u_t.norm();
    const bool presses = rows[i].n.dot(rows[i].P) > 0;
    slips.push_back(presses && speed > 0 ? Slip{speed, u_t.dot(relative_velocity(at_end[i], twists)) / speed} : Slip{});
  }
  return slips;
}

std::vector<Mobility> mobilities_of(const std::vector<StepBody>& step_bodies) {
  std::vector<Mobility> all;
  for (const StepBody& step_body : step_bodies) all.push_back(step_body.mobility());
  return all;
}

}  // namespace

RigidTransform StepBody::transform() const {
  const Mat3 R = lin_canny::rotation(state.X_WB.q_WB);
  return {state.X_WB.p_WB + R * model->p_BBcm, R};
}

Mobility StepBody::mobility() const {
  if (is_fixed()) return {};
  if (is_round(*model)) return {1 / model->mass, inverse_inertia(*model)};
  const Mat3 R = lin_canny::rotation(state.X_WB.q_WB);
  return {1 / model->mass, R * inverse_inertia(*model) * R.transpose()};
}

double StepBody::kinetic_energy() const {
  const Velocity& V = state.velocity;
  const Vec3 w_B = lin_canny::rotation(state.X_WB.q_WB).transpose() * V.w_WB;
  return (model->mass * V.v_WBcm.squaredNorm() + w_B.dot(model->I_BBcm_B * w_B)) / 2;
}

Stepped step(const std::vector<StepBody>& step_bodies, std::vector<ContactConstraint>& constraints, double h,
             double tolerance, double recovery) {
  std::vector<BodyStep> bodies;
  std::vector<Mobility> mobilities = mobilities_of(step_bodies);
  std::vector<Twist> mean;
  for (const StepBody& step_body : step_bodies) {
    BodyStep& body = bodies.emplace_back(step_body);
    mean.push_back(twist(step_body.state));
    body.go(mean.back(), mean.back(), h);
  }
  std::vector<Nearness> before;
  std::vector<double> least_u_n;
  for (const ContactConstraint& constraint : constraints) {
    before.push_back(
        nearness_of(constraint, bodies[constraint.a].before, bodies[constraint.b].before, constraint.about));
    least_u_n.push_back(std::min(-before.back().gap / h, recovery));
  }
  std::vector<ContactRow> rows(constraints.size());
  // The rows' error in the gap (m): features move along curves.
  std::vector<double> missed(constraints.size(), 0.0);
  double change = 0;
  for (int round = 0; round < most_rounds; ++round) {
    mark(Mark::contact_round);
    mark(Mark::contact_row, constraints.size());
    for (std::size_t i = 0; i < constraints.size(); ++i) {
      const ContactConstraint& constraint = constraints[i];
      const Nearness after =
          nearness_of(constraint, bodies[constraint.a].after, bodies[constraint.b].after, before[i].nhat_BA_W);
      const double over = after.gap - (before[i].gap + h * least_u_n[i]);
      if (round >= first_corrected && (over < 0 || !rows[i].P.isZero(0))) missed[i] += over;
      const Vec3 guess = round > 0 ? rows[i].P : expected_impulse(constraint.contact_point, h);
      rows[i] = row_of(constraint, before[i], after, bodies);
      rows[i].P = guess;
      rows[i].least_u_n = least_u_n[i];
      follow_curve(rows[i], missed[i], negligible_miss * tolerance, h, mean, bodies);
      prepare(rows[i], mobilities);
    }
    std::vector<Twist> free;
    for (const BodyStep& body : bodies) free.push_back(body.free(h));
    mean = free;
    solve_combined(rows, mobilities, mean,
                   {.sweeps = sweeps_of_a_round,
                    .sweeps_per_active_set = 64,
                    .enough = std::min(tolerance / h, of_recovery * recovery)});
    const double changed = change;
    change = 0;
    for (std::size_t i = 0; i < bodies.size(); ++i) change = std::max(change, bodies[i].go(mean[i], free[i], h));
    const bool is_stuck = round > first_corrected + 1 && change > changed / 2;  // as accurate as the sweeps get
    if (change <= tolerance || is_stuck) break;
  }
  std::vector<StepBody> moved = step_bodies;
  std::vector<Twist> twists;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    moved[i].state = bodies[i].state(mean[i]);
    twists.push_back(twist(moved[i].state));
  }
  for (std::size_t i = 0; i < constraints.size(); ++i) {
    constraints[i].contact_point.F_A_W = 2 / h * rows[i].P;
    constraints[i].contact_point.h = h;
  }
  mobilities = mobilities_of(moved);
  const std::vector<ContactRow> at_end = rows_at(moved, constraints, mobilities);
  Stepped stepped;
  stepped.slips = slips_of(bodies, before, rows, at_end, twists);
  project_velocities(at_end, rows, mean, mobilities, twists);
  stepped.residual = residual_of_step(constraints, bodies, before, least_u_n, rows, mean, h);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (!moved[i].is_fixed()) set_velocity(moved[i].state, twists[i]);
    stepped.after.push_back(moved[i].state);
  }
  stepped.mean = std::move(mean);
  return stepped;
}

double unbalanced(const std::vector<StepBody>& step_bodies, std::vector<ContactConstraint>& constraints) {
  const std::vector<Mobility> mobilities = mobilities_of(step_bodies);
  std::vector<ContactRow> rows = rows_at(step_bodies, constraints, mobilities);
  std::vector<Twist> left(step_bodies.size());
  double greatest = 0, most = 0;
  for (std::size_t i = 0; i < step_bodies.size(); ++i) {
    if (step_bodies[i].is_fixed()) continue;
    left[i].v = step_bodies[i].acceleration;
    greatest = std::max(greatest, step_bodies[i].acceleration.norm());
  }
  balance(rows, mobilities, left);
  for (std::size_t i = 0; i < step_bodies.size(); ++i) {
    if (!step_bodies[i].is_fixed())
      most = std::max(most, left[i].v.norm() + step_bodies[i].model->radius * left[i].w.norm());
  }
  for (std::size_t i = 0; i < constraints.size(); ++i) constraints[i].contact_point.F_A_W = rows[i].P;
  return most / greatest;
}

void land(std::vector<StepBody>& step_bodies, const std::vector<ContactConstraint>& constraints) {
  const std::vector<Mobility> mobilities = mobilities_of(step_bodies);
  std::vector<ContactRow> rows = rows_at(step_bodies, constraints, mobilities);
  std::vector<Twist> twists;
  for (const StepBody& step_body : step_bodies) twists.push_back(twist(step_body.state));
  solve_combined(rows, mobilities, twists, {});
  for (std::size_t i = 0; i < step_bodies.size(); ++i) {
    if (!step_bodies[i].is_fixed()) set_velocity(step_bodies[i].state, twists[i]);
  }
}

}  // namespace touchstone::fast::contact
