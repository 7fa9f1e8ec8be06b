#include "fast/contact/solver.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "fast/contact/active_set.h"
#include "fast/contact/cross_matrix.h"
#include "fast/mark.h"
#include "model/infinity.h"

namespace touchstone::fast::contact {
namespace {

constexpr double convergence = 0x1p-44;
constexpr int sweeps_of_a_block = 32;
constexpr double least_reduction = 4;  // of the change, from block to block

/// A body as a contact moves it.
struct SweptBody {
  SweptBody(int of_row, const Vec3& its_arm, const std::vector<Mobility>& bodies)
      : body(index(of_row)), arm(its_arm), inverse_mass(bodies[body].inverse_mass) {
    turn = bodies[body].inverse_inertia * cross_matrix(arm);
  }

  std::size_t body;
  Vec3 arm;
  Mat3 turn;  ///< the angular velocity that an impulse adds, 1/(kg m)
  double inverse_mass;
};

/// What a sweep reads of a contact, in one place.
struct SweptContact {
  SweptContact(const ContactRow& row, const std::vector<Mobility>& bodies)
      : A(row.a, row.arm_A, bodies), B(row.b, row.arm_B, bodies), n(row.n), K_n(row.K_n), P(row.P) {
    friction = row.friction;
    least_u_n = row.least_u_n;
    K_nn = row.K_nn;
    compliance_nn = 1 / row.K_nn;
    compliance_tt = 1 / row.K_tt;
    stiffest = std::max(row.K_nn, row.K_tt);
  }

  SweptBody A, B;
  Vec3 n, K_n, P;
  double friction, least_u_n, K_nn, compliance_nn, compliance_tt, stiffest;
};

std::vector<SweptContact> swept(const std::vector<ContactRow>& rows, const std::vector<Mobility>& bodies) {
  std::vector<SweptContact> all;
  all.reserve(rows.size());
  for (const ContactRow& row : rows) all.emplace_back(row, bodies);
  return all;
}

inline void apply_impulse(const SweptContact& contact, const Vec3& P, std::vector<Twist>& twists) {
  Twist &A = twists[contact.A.body], &B = twists[contact.B.body];
  A.v += contact.A.inverse_mass * P;
  A.w += contact.A.turn * P;
  B.v -= contact.B.inverse_mass * P;
  B.w -= contact.B.turn * P;
}

/// Solves one contact with the others fixed. Returns the square of how much a velocity at the contact changed.
double relax(SweptContact& contact, std::vector<Twist>& twists) {
  const Twist &A = twists[contact.A.body], &B = twists[contact.B.body];
  const Vec3& n = contact.n;
  Vec3 u = A.v - B.v + A.w.cross(contact.A.arm) - B.w.cross(contact.B.arm);
  const double P_n = n.dot(contact.P);
  const double pushed = std::max(0.0, P_n + (contact.least_u_n - n.dot(u)) * contact.compliance_nn);
  u += (pushed - P_n) * contact.K_n;
  // The guess may belong to another normal. Its part across the new normal counts as friction, and is projected onto
  // the disc too.
  Vec3 P_t = contact.P - P_n * n - (u - n.dot(u) * n) * contact.compliance_tt;
  const double square = P_t.squaredNorm(), most = contact.friction * pushed;
  if (square > most * most) P_t *= most / std::sqrt(square);
  const Vec3 P = pushed * n + P_t, dP = P - contact.P;
  contact.P = P;
  apply_impulse(contact, dP, twists);
  return dP.squaredNorm() * contact.stiffest * contact.stiffest;
}

/// Size of the terms that make up a velocity at the end of an arm; rounding is relative to these.
double greatest(const Twist& twist, const Vec3& arm) { return twist.v.norm() + twist.w.norm() * arm.norm(); }

double sweep(std::vector<SweptContact>& contacts, std::vector<Twist>& twists) {
  mark(Mark::contact_sweep);
  mark(Mark::contact_row, contacts.size());

  double square = 0;
  for (SweptContact& contact : contacts) square = std::max(square, relax(contact, twists));
  return std::sqrt(square);
}

void keep_impulses(const std::vector<SweptContact>& contacts, std::vector<ContactRow>& rows) {
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i].P = contacts[i].P;
}

/// Nonlinear conjugate gradients: the change of a sweep counts as minus a gradient, and P is extrapolated along a
/// direction conjugate to the last one before the next sweep, which projects onto the disc. Restarts where changes
/// grow. Source: Silcowitz, Niebe & Erleben 2010.
class Descent {
 public:
  explicit Descent(std::size_t rows) : before_(rows), direction_(rows, Vec3::Zero()) {}

  void begin(const std::vector<SweptContact>& contacts) {
    for (std::size_t i = 0; i < contacts.size(); ++i) before_[i] = contacts[i].P;
  }
  void go_on(std::vector<SweptContact>& contacts, std::vector<Twist>& twists) {
    double steep = 0;
    for (std::size_t i = 0; i < contacts.size(); ++i)
      steep += contacts[i].K_nn * (contacts[i].P - before_[i]).squaredNorm();
    const double beta = steep_ > 0 && steep <= steep_ ? steep / steep_ : 0;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      const Vec3 further = beta * direction_[i];
      direction_[i] = further + (contacts[i].P - before_[i]);
      if (beta > 0) apply_impulse(contacts[i], further, twists);
      contacts[i].P += further;
    }
    steep_ = steep;
  }

 private:
  std::vector<Vec3> before_, direction_;
  double steep_ = 0;
};

/// `change`: of the preceding sweep.
void try_active_set(std::vector<ContactRow>& rows, std::vector<SweptContact>& contacts,
                    const std::vector<Mobility>& bodies, std::vector<Twist>& twists, double change) {
  const std::vector<SweptContact> contacts_before = contacts;
  const std::vector<Twist> twists_before = twists;
  keep_impulses(contacts, rows);
  solve_active_set(rows, bodies, twists);
  for (std::size_t i = 0; i < rows.size(); ++i) contacts[i].P = rows[i].P;
  if (sweep(contacts, twists) < change) return;
  contacts = contacts_before;
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
  std::vector<SweptContact> contacts = swept(rows, bodies);
  double fastest = 0;
  for (const ContactRow& row : rows) {
    fastest = std::max({fastest, std::abs(row.least_u_n), greatest(twists[index(row.a)], row.arm_A),
                        greatest(twists[index(row.b)], row.arm_B)});
    apply_impulse(row, row.P, bodies, twists);
  }
  Descent descent(rows.size());
  double least = infinity, least_before = infinity;  // change in this block, and in the one before
  bool converged = false;
  for (int i = 1; i <= limits.sweeps; ++i) {
    descent.begin(contacts);
    const double change = sweep(contacts, twists);
    converged = change <= std::max(convergence * fastest, limits.enough);
    if (converged) break;
    least = std::min(least, change);
    if (i % sweeps_of_a_block == 0) {
      if (!limits.is_patient && least * least_reduction > least_before) break;
      least_before = std::exchange(least, infinity);
    }
    if (i % limits.sweeps_per_active_set == 0 && rows.size() <= limits.most_active_set_contacts) {
      try_active_set(rows, contacts, bodies, twists, change);
      descent = Descent(rows.size());
    } else if (i < limits.sweeps) {
      descent.go_on(contacts, twists);
    }
  }
  keep_impulses(contacts, rows);
  return converged;
}

}  // namespace touchstone::fast::contact
