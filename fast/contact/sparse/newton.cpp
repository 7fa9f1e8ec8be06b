#include "fast/contact/sparse/newton.h"

#include <algorithm>
#include <cmath>

#include "fast/contact/solver.h"
#include "fast/contact/sparse/friction_cone.h"
#include "fast/contact/sparse/twist_system.h"
#include "fast/mark.h"
#include "model/infinity.h"

namespace touchstone::fast::contact {
namespace {

using Vector = TwistSystem::Vector;

constexpr double newton_convergence = 0x1p-44;  // of the greatest velocity, as for sweeps
constexpr double newton_rounding = 0x1p-50;     // of the greatest velocity, times ρ: what Newton steps can reach
constexpr double bonded_penalty = 0x1p20;
constexpr double polish_penalty = 0x1p26;
constexpr double first_penalty = 0x1p10, most_penalty = 0x1p24, least_penalty = 0x1p-6;
constexpr double penalty_growth = 4, penalty_cut = 0x1p-3;
constexpr double ceiling_growth = 2;  // of the greatest penalty after one at which Newton steps did not converge
constexpr int most_newton_steps_of_round = 20;
constexpr int most_halvings_of_round = 12;
constexpr double least_decrease = 0x1p-13;

class Newton {
 public:
  Newton(std::vector<ContactRow>& rows, const std::vector<Mobility>& bodies, const std::vector<Twist>& twists,
         const NewtonLimits& limits)
      : rows_(rows), limits_(limits), system_(rows, bodies), free_(system_.moving(twists)) {
    std::vector<Twist> fixed = twists;
    system_.store(system_.zero(), fixed);
    double fastest = system_.greatest_speed(free_);
    for (const ContactRow& row : rows) {
      ContactState& state = contacts_.emplace_back();
      state.mass = 1 / row.K_nn;
      state.of_fixed = contact::relative_velocity(row, fixed);
      fastest = std::max({fastest, std::abs(row.least_u_n), state.of_fixed.norm()});
    }
    fastest_ = fastest;
    enough_ = std::max(limits.enough, newton_convergence * fastest);
    stiffness_.resize(rows.size());
  }

  bool run(std::vector<Twist>& twists) {
    if (std::ranges::all_of(rows_, [](const ContactRow& row) { return row.P.isZero(0); })) start_bonded();
    v_ = with_impulses();
    const bool done = keep_best() || rounds();
    for (std::size_t i = 0; i < rows_.size(); ++i) rows_[i].P = contacts_[i].best;
    system_.store(with_impulses(), twists);
    return done;
  }

 private:
  struct ContactState {
    double mass = 0;                             ///< the effective one along the normal (kg)
    Vec3 of_fixed = Vec3::Zero();                ///< the part of u that bodies which do not react have (m/s)
    Vec3 Q = Vec3::Zero(), best = Vec3::Zero();  ///< N s
  };

  Vec3 velocity(std::size_t i, const Vector& v) const {
    return system_.relative_velocity(i, v) + contacts_[i].of_fixed;
  }
  /// u − least_u_n n
  Vec3 excess(std::size_t i, const Vector& v) const { return velocity(i, v) - rows_[i].least_u_n * rows_[i].n; }

  Vector with_impulses() const {
    Vector wrenches = system_.zero();
    for (std::size_t i = 0; i < rows_.size(); ++i) system_.add_impulse(i, rows_[i].P, wrenches);
    return free_ + system_.response(wrenches);
  }

  /// Keeps P if it is the best so far. Returns whether it is good enough.
  bool keep_best() {
    residual_ = 0;
    for (std::size_t i = 0; i < rows_.size(); ++i) residual_ = std::max(residual_, residual(rows_[i], velocity(i, v_)));
    if (residual_ < least_) {
      least_ = residual_;
      for (std::size_t i = 0; i < rows_.size(); ++i) contacts_[i].best = rows_[i].P;
    }
    return residual_ <= enough_;
  }

  /// All contacts hold, and then what the friction discs do not allow is cut off.
  void start_bonded() {
    Vector wrenches = system_.momentum(free_);
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const double k = bonded_penalty * contacts_[i].mass;
      stiffness_[i] = k * Mat3::Identity();
      system_.add_impulse(i, -k * (contacts_[i].of_fixed - rows_[i].least_u_n * rows_[i].n), wrenches);
    }
    system_.factor(1, stiffness_);
    const Vector v = system_.solve(std::move(wrenches));
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const Vec3 P = -bonded_penalty * contacts_[i].mass * excess(i, v);
      rows_[i].P = nearest_in_disc(P, rows_[i].n, rows_[i].friction).P;
    }
  }

  /// M (v − v_free) − GᵀQ as a velocity; Q and the stiffnesses at v.
  double evaluate(const Vector& v, double penalty, Vector& missing) {
    missing = system_.momentum(v - free_);
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const double k = penalty * contacts_[i].mass;
      const ConeImpulse impulse = nearest_in_disc(rows_[i].P - k * excess(i, v), rows_[i].n, rows_[i].friction);
      contacts_[i].Q = impulse.P;
      stiffness_[i] = k * impulse.derivative;
      system_.add_impulse(i, -contacts_[i].Q, missing);
    }
    return system_.greatest_speed(system_.response(missing));
  }

  /// Solves a round for v and Q. Returns whether it converged.
  bool converge(double penalty, Vector& v) {
    const double within = std::max(enough_ / 4, newton_rounding * penalty * fastest_);
    Vector missing, next_missing;
    double size = evaluate(v, penalty, missing);
    for (int k = 0; k < most_newton_steps_of_round && size > within; ++k) {
      if (++factorisations_ > limits_.factorisations) return false;
      mark(Mark::contact_newton);
      mark(Mark::contact_row, rows_.size());
      system_.factor(1, stiffness_);
      const Vector step = system_.solve(missing);
      double part = 1, next_size = infinity;
      Vector next;
      for (int halving = 0; halving < most_halvings_of_round; ++halving, part /= 2) {
        next = v - part * step;
        next_size = evaluate(next, penalty, next_missing);
        if (next_size <= (1 - least_decrease * part) * size) break;
      }
      if (!(next_size < size)) return false;
      v = next;
      missing = next_missing;
      size = next_size;
    }
    return size <= within;
  }

  /// Takes from P and v which contacts are open, stick and slip, and solves for these states at once, with a penalty so
  /// large that bodies far from the ground are reached too; impulses then change by what is left of the velocities, so
  /// rounding is relative to that. Keeps the result if its residual is at most half as large. Returns whether it is.
  bool polish(double penalty) {
    if (++factorisations_ > limits_.factorisations) return false;
    mark(Mark::contact_newton);
    mark(Mark::contact_row, rows_.size());
    const std::vector<ContactRow> rows_before = rows_;
    const Vector v_before = v_;
    const double residual_before = residual_;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      ContactRow& row = rows_[i];
      const double mass = contacts_[i].mass;
      const Vec3 u = velocity(i, v_), z = row.P - penalty * mass * excess(i, v_);
      const double z_n = row.n.dot(z), P_n = std::max(0.0, row.n.dot(row.P));
      const Vec3 z_t = z - z_n * row.n;
      const double size = z_t.norm();
      if (!(z_n > 0)) {
        row.P.setZero();
        stiffness_[i].setZero();
      } else if (size <= row.friction * z_n) {
        stiffness_[i] = polish_penalty * mass * Mat3::Identity();
      } else {
        const Vec3 d = z_t / size, edge = row.n + row.friction * d;
        const Mat3 sideways = Mat3::Identity() - row.n * row.n.transpose() - d * d.transpose();
        const double speed = (u - row.n.dot(u) * row.n).norm();
        const double turning = row.friction * P_n / (speed + row.friction * P_n / (polish_penalty * mass));
        row.P = P_n * edge;
        stiffness_[i] = polish_penalty * mass * edge * row.n.transpose();
        if (row.friction * P_n > 0) stiffness_[i] += turning * sideways;
      }
    }
    v_ = with_impulses();
    Vector wrenches = system_.zero();
    for (std::size_t i = 0; i < rows_.size(); ++i) system_.add_impulse(i, -(stiffness_[i] * excess(i, v_)), wrenches);
    system_.factor(1, stiffness_);
    const Vector change = system_.solve(std::move(wrenches));
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const Vec3 P = rows_[i].P - stiffness_[i] * (excess(i, v_) + system_.relative_velocity(i, change));
      rows_[i].P = nearest_in_disc(P, rows_[i].n, rows_[i].friction).P;
    }
    v_ = with_impulses();
    keep_best();
    if (residual_ <= residual_before / 2) return true;
    rows_ = rows_before;
    v_ = v_before;
    residual_ = residual_before;
    return false;
  }

  bool rounds() {
    double penalty = first_penalty, most = most_penalty;
    while (penalty >= least_penalty && factorisations_ <= limits_.factorisations) {
      Vector v = v_;
      if (!converge(penalty, v)) {
        penalty = most = penalty * penalty_cut;
        continue;
      }
      for (std::size_t i = 0; i < rows_.size(); ++i) rows_[i].P = contacts_[i].Q;
      v_ = with_impulses();
      if (keep_best()) return true;
      while (polish(penalty)) {
        if (residual_ <= enough_) return true;
      }
      most = std::min(most_penalty, most * ceiling_growth);
      penalty = std::min(most, penalty * penalty_growth);
    }
    return false;
  }

  std::vector<ContactRow>& rows_;
  const NewtonLimits& limits_;
  TwistSystem system_;
  Vector free_, v_;
  double fastest_ = 0, enough_ = 0, least_ = infinity, residual_ = 0;
  int factorisations_ = 0;
  std::vector<ContactState> contacts_;
  std::vector<Mat3> stiffness_;
};

}  // namespace

bool solve_newton(std::vector<ContactRow>& rows, const std::vector<Mobility>& bodies, std::vector<Twist>& twists,
                  const NewtonLimits& limits) {
  return Newton(rows, bodies, twists, limits).run(twists);
}

}  // namespace touchstone::fast::contact
