#include "fast/constraint/solve.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "fast/constraint/active_set.h"
#include "fast/constraint/cross_matrix.h"

namespace touchstone::fast::constraint {
namespace {

constexpr double convergence = 0x1p-44;

Mat3 mobility(const Mobility& body, const Vec3& arm) {
  const Mat3 r = cross_matrix(arm);
  return body.inverse_mass * Mat3::Identity() - r * body.inverse_inertia * r;
}

/// Solves one contact with the others fixed. Returns how much a velocity at the contact changed.
double relax(Touch& touch, const std::vector<Mobility>& bodies, std::vector<Twist>& twists) {
  const Vec3 before = touch.P;
  const double P_n = touch.n.dot(touch.P);
  const double u_n = touch.n.dot(relative_velocity(touch, twists));
  const double pushed = std::max(0.0, P_n + (touch.least_u_n - u_n) / touch.K_nn);
  // The guess may belong to another normal. Its part across the new normal counts as friction, and is projected onto
  // the disc too.
  Vec3 P_t = touch.P - P_n * touch.n;
  touch.P += (pushed - P_n) * touch.n;
  push(touch, touch.P - before, bodies, twists);
  const Vec3 with_normal = touch.P;
  const Vec3 u = relative_velocity(touch, twists);
  P_t -= (u - touch.n.dot(u) * touch.n) / touch.K_tt;
  const double size = P_t.norm(), most = touch.friction * pushed;
  if (size > most) P_t *= most / size;
  touch.P = pushed * touch.n + P_t;
  push(touch, touch.P - with_normal, bodies, twists);
  return (touch.P - before).norm() * std::max(touch.K_nn, touch.K_tt);
}

/// Size of the terms that make up a velocity at the end of an arm; rounding is relative to these.
double greatest(const Twist& twist, const Vec3& arm) { return twist.v.norm() + twist.w.norm() * arm.norm(); }

double sweep(std::vector<Touch>& touches, const std::vector<Mobility>& bodies, std::vector<Twist>& twists) {
  double change = 0;
  for (Touch& touch : touches) change = std::max(change, relax(touch, bodies, twists));
  return change;
}

/// Nonlinear conjugate gradients: the change of a sweep counts as minus a gradient, and P is extrapolated along a
/// direction conjugate to the last one before the next sweep, which projects onto the disc. Restarts where changes
/// grow. Source: Silcowitz, Niebe & Erleben 2010.
class Descent {
 public:
  explicit Descent(std::size_t touches) : before_(touches), direction_(touches, Vec3::Zero()) {}

  void begin(const std::vector<Touch>& touches) {
    for (std::size_t i = 0; i < touches.size(); ++i) before_[i] = touches[i].P;
  }
  void go_on(std::vector<Touch>& touches, const std::vector<Mobility>& bodies, std::vector<Twist>& twists) {
    double steep = 0;
    for (std::size_t i = 0; i < touches.size(); ++i)
      steep += touches[i].K_nn * (touches[i].P - before_[i]).squaredNorm();
    const double beta = steep_ > 0 && steep <= steep_ ? steep / steep_ : 0;
    for (std::size_t i = 0; i < touches.size(); ++i) {
      const Vec3 further = beta * direction_[i];
      direction_[i] = further + (touches[i].P - before_[i]);
      if (beta > 0) push(touches[i], further, bodies, twists);
      touches[i].P += further;
    }
    steep_ = steep;
  }

 private:
  std::vector<Vec3> before_, direction_;
  double steep_ = 0;
};

/// `change`: of the preceding sweep.
void try_active_set(std::vector<Touch>& touches, const std::vector<Mobility>& bodies, std::vector<Twist>& twists,
                    double change) {
  const std::vector<Touch> touches_before = touches;
  const std::vector<Twist> twists_before = twists;
  solve_active_set(touches, bodies, twists);
  if (sweep(touches, bodies, twists) < change) return;
  touches = touches_before;
  twists = twists_before;
}

}  // namespace

void prepare(Touch& touch, const std::vector<Mobility>& bodies) {
  const Mat3 K = mobility(bodies[index(touch.a)], touch.arm_A) + mobility(bodies[index(touch.b)], touch.arm_B);
  const Vec3 t = touch.n.unitOrthogonal(), s = touch.n.cross(t);
  touch.K_nn = touch.n.dot(K * touch.n);
  const double tt = t.dot(K * t), ss = s.dot(K * s), ts = t.dot(K * s), half = (tt - ss) / 2;
  touch.K_tt = (tt + ss) / 2 + std::sqrt(half * half + ts * ts);
}

void push(const Touch& touch, const Vec3& P, const std::vector<Mobility>& bodies, std::vector<Twist>& twists) {
  const Mobility &A = bodies[index(touch.a)], &B = bodies[index(touch.b)];
  Twist &of_A = twists[index(touch.a)], &of_B = twists[index(touch.b)];
  of_A.v += A.inverse_mass * P;
  of_A.w += A.inverse_inertia * touch.arm_A.cross(P);
  of_B.v -= B.inverse_mass * P;
  of_B.w -= B.inverse_inertia * touch.arm_B.cross(P);
}

Vec3 relative_velocity(const Touch& touch, const std::vector<Twist>& twists) {
  const Twist &A = twists[index(touch.a)], &B = twists[index(touch.b)];
  return A.v + A.w.cross(touch.arm_A) - B.v - B.w.cross(touch.arm_B);
}

void solve(std::vector<Touch>& touches, const std::vector<Mobility>& bodies, std::vector<Twist>& twists,
           const Effort& effort) {
  double fastest = 0;
  for (Touch& touch : touches) {
    fastest = std::max({fastest, std::abs(touch.least_u_n), greatest(twists[index(touch.a)], touch.arm_A),
                        greatest(twists[index(touch.b)], touch.arm_B)});
    push(touch, touch.P, bodies, twists);
  }
  Descent descent(touches.size());
  for (int i = 1; i <= effort.sweeps; ++i) {
    descent.begin(touches);
    const double change = sweep(touches, bodies, twists);
    if (change <= std::max(convergence * fastest, effort.enough)) return;
    if (i % effort.sweeps_per_active_set == 0 && touches.size() <= effort.most_active_set_contacts) {
      try_active_set(touches, bodies, twists, change);
      descent = Descent(touches.size());
    } else if (i < effort.sweeps) {
      descent.go_on(touches, bodies, twists);
    }
  }
}

}  // namespace touchstone::fast::constraint
