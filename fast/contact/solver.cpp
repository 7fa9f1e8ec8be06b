#include "fast/contact/solver.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "fast/contact/active_set.h"
#include "fast/mark.h"
#include "model/infinity.h"

namespace touchstone::fast::contact {
namespace {

constexpr double convergence = 0x1p-44;
constexpr int sweeps_of_a_block = 32;
constexpr double least_reduction = 4;  // of the change, from block to block

/// Solves one contact with the others fixed. Returns how much a velocity at the contact changed.
double relax(ContactRow& row, const std::vector<Mobility>& bodies, std::vector<Twist>& twists) {
  const Vec3 before = row.P, u_before = relative_velocity(row, twists);
  const double P_n = row.n.dot(row.P);
  const double pushed = std::max(0.0, P_n + (row.least_u_n - row.n.dot(u_before)) / row.K_nn);
  const Vec3 u = u_before + (pushed - P_n) * row.K_n;
  // The guess may belong to another normal. Its part across the new normal counts as friction, and is projected onto
  // the disc too.
  Vec3 P_t = row.P - P_n * row.n - (u - row.n.dot(u) * row.n) / row.K_tt;
  const double size = P_t.norm(), most = row.friction * pushed;
  if (size > most) P_t *= most / size;
  row.P = pushed * row.n + P_t;
  apply_impulse(row, row.P - before, bodies, twists);
  return (row.P - before).norm() * std::max(row.K_nn, row.K_tt);
}

/// Size of the terms that make up a velocity at the end of an arm; rounding is relative to these.
double greatest(const Twist& twist, const Vec3& arm) { return twist.v.norm() + twist.w.norm() * arm.norm(); }

double sweep(std::vector<ContactRow>& rows, const std::vector<Mobility>& bodies, std::vector<Twist>& twists) {
  mark(Mark::contact_sweep);
  mark(Mark::contact_row, rows.size());
  double change = 0;
  for (ContactRow& row : rows) change = std::max(change, relax(row, bodies, twists));
  return change;
}

/// Nonlinear conjugate gradients: the change of a sweep counts as minus a gradient, and P is extrapolated along a
/// direction conjugate to the last one before the next sweep, which projects onto the disc. Restarts where changes
/// grow. Source: Silcowitz, Niebe & Erleben 2010.
class Descent {
 public:
  explicit Descent(std::size_t rows) : before_(rows), direction_(rows, Vec3::Zero()) {}

  void begin(const std::vector<ContactRow>& rows) {
    for (std::size_t i = 0; i < rows.size(); ++i) before_[i] = rows[i].P;
  }
  void go_on(std::vector<ContactRow>& rows, const std::vector<Mobility>& bodies, std::vector<Twist>& twists) {
    double steep = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) steep += rows[i].K_nn * (rows[i].P - before_[i]).squaredNorm();
    const double beta = steep_ > 0 && steep <= steep_ ? steep / steep_ : 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Vec3 further = beta * direction_[i];
      direction_[i] = further + (rows[i].P - before_[i]);
      if (beta > 0) apply_impulse(rows[i], further, bodies, twists);
      rows[i].P += further;
    }
    steep_ = steep;
  }

 private:
  std::vector<Vec3> before_, direction_;
  double steep_ = 0;
};

/// `change`: of the preceding sweep.
void try_active_set(std::vector<ContactRow>& rows, const std::vector<Mobility>& bodies, std::vector<Twist>& twists,
                    double change) {
  const std::vector<ContactRow> touches_before = rows;
  const std::vector<Twist> twists_before = twists;
  solve_active_set(rows, bodies, twists);
  if (sweep(rows, bodies, twists) < change) return;
  rows = touches_before;
  twists = twists_before;
}

}  // namespace

double residual(const ContactRow& row, const Vec3& u) {
  const double P_n = row.n.dot(row.P), u_n = row.n.dot(u);
  const Vec3 P_t = row.P - P_n * row.n;
  Vec3 corrected = P_t - (u - u_n * row.n) / row.K_tt;
  const double size = corrected.norm(), most = row.friction * std::max(P_n, 0.0);
  if (size > most) corrected *= most / size;
  return std::max(std::abs(std::min(row.K_nn * P_n, u_n - row.least_u_n)), row.K_tt * (P_t - corrected).norm());
}

bool solve(std::vector<ContactRow>& rows, const std::vector<Mobility>& bodies, std::vector<Twist>& twists,
           const SolverLimits& limits) {
  double fastest = 0;
  for (ContactRow& row : rows) {
    fastest = std::max({fastest, std::abs(row.least_u_n), greatest(twists[index(row.a)], row.arm_A),
                        greatest(twists[index(row.b)], row.arm_B)});
    apply_impulse(row, row.P, bodies, twists);
  }
  Descent descent(rows.size());
  double least = infinity, least_before = infinity;  // change in this block, and in the one before
  for (int i = 1; i <= limits.sweeps; ++i) {
    descent.begin(rows);
    const double change = sweep(rows, bodies, twists);
    if (change <= std::max(convergence * fastest, limits.enough)) return true;
    least = std::min(least, change);
    if (i % sweeps_of_a_block == 0) {
      if (!limits.is_patient && least * least_reduction > least_before) return false;
      least_before = std::exchange(least, infinity);
    }
    if (i % limits.sweeps_per_active_set == 0 && rows.size() <= limits.most_active_set_contacts) {
      try_active_set(rows, bodies, twists, change);
      descent = Descent(rows.size());
    } else if (i < limits.sweeps) {
      descent.go_on(rows, bodies, twists);
    }
  }
  return false;
}

}  // namespace touchstone::fast::contact
