#include "fast/contact/sparse/balance.h"

#include <algorithm>
#include <cmath>

#include "fast/contact/sparse/friction_cone.h"
#include "fast/contact/sparse/twist_system.h"
#include "fast/mark.h"

namespace touchstone::fast::contact {
namespace {

using Vector = TwistSystem::Vector;

constexpr double balanced = 0x1p-33;      // of the greatest load's twist
constexpr double nearly = 0x1p-13;        // from here on the impulses are corrected by themselves
constexpr double bonded_share = 0x1p-43;  // s of the bonded solve: what keeps H regular, beyond rounding
constexpr double first_share = 0x1p-10, last_share = 0x1p-40, share_ratio = 0x1p-3;
constexpr int most_corrections = 6;
constexpr int most_newton_steps_of_balance = 30;
constexpr int most_halvings_of_balance = 20;
constexpr double armijo = 0x1p-13;
constexpr double newton_tolerance = 0x1p-40;  // of the greatest load's twist
constexpr double parts_within = 0x1p-23;      // of the greatest speed: the motion in which bodies fall

/// The search of one set of contacts.
class Search {
 public:
  Search(std::vector<ContactRow>& rows, const std::vector<Mobility>& bodies, const std::vector<Twist>& twists)
      : rows_(rows), system_(rows, bodies), load_(system_.momentum(system_.moving(twists))) {
    greatest_ = system_.greatest_speed(system_.response(load_));
    for (const ContactRow& row : rows) stiffness_.push_back(1 / row.K_nn);
    derivatives_.resize(rows.size());
  }

  /// The best impulses, and the twists that they leave. Returns the motion that proves that the bodies fall.
  std::optional<std::vector<Twist>> run(std::vector<Twist>& twists) {
    least_ = greatest_;
    best_.assign(rows_.size(), Vec3::Zero());
    std::optional<Vector> motion;
    if (greatest_ > 0 && !bonded()) motion = minimise();
    for (std::size_t i = 0; i < rows_.size(); ++i) rows_[i].P = best_[i];
    system_.store(system_.response(left_of(best_)), twists);
    if (!motion) return std::nullopt;
    std::vector<Twist> falling(twists.size());
    system_.store(*motion, falling);
    return falling;
  }

 private:
  Vector left_of(const std::vector<Vec3>& P) const {
    Vector left = load_;
    for (std::size_t i = 0; i < P.size(); ++i) system_.add_impulse(i, P[i], left);
    return left;
  }

  /// Keeps the impulses if they are the best so far. Returns how much is left, relative to the greatest load.
  double keep(const std::vector<Vec3>& P) {
    const double left = system_.greatest_speed(system_.response(left_of(P)));
    if (left < least_) {
      least_ = left;
      best_ = P;
    }
    return left / greatest_;
  }

  bool bonded() {
    for (std::size_t i = 0; i < rows_.size(); ++i) derivatives_[i] = stiffness_[i] * Mat3::Identity();
    mark(Mark::balance_step);
    mark(Mark::contact_row, rows_.size());
    system_.factor(bonded_share, derivatives_);
    std::vector<Vec3> P(rows_.size(), Vec3::Zero());
    for (int k = 0; k < most_corrections; ++k) {
      const Vector y = system_.solve(left_of(P));
      for (std::size_t i = 0; i < rows_.size(); ++i) P[i] -= stiffness_[i] * system_.relative_velocity(i, y);
      std::vector<Vec3> in_cones = P;
      for (std::size_t i = 0; i < rows_.size(); ++i)
        in_cones[i] = nearest_in_cone(P[i], rows_[i].n, rows_[i].friction).P;
      if (keep(in_cones) <= balanced) return true;
    }
    return false;
  }

  /// φ and its gradient, both with the proximal term; the impulses and stiffnesses at y.
  double evaluate(const Vector& y, double share, Vector& gradient, std::vector<Vec3>& P) {
    const Vector from_last = system_.momentum(y - last_);
    gradient = share * from_last - load_;
    double phi = share * from_last.dot(y - last_) / 2 - load_.dot(y);
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const ConeImpulse impulse =
          nearest_in_cone(-stiffness_[i] * system_.relative_velocity(i, y), rows_[i].n, rows_[i].friction);
      P[i] = impulse.P;
      derivatives_[i] = stiffness_[i] * impulse.derivative;
      phi += P[i].squaredNorm() / (2 * stiffness_[i]);
      system_.add_impulse(i, -P[i], gradient);
    }
    return phi;
  }

  /// P ← Π(P − k G H⁻¹ (f + GᵀP)), with the factors at the last y.
  bool correct(std::vector<Vec3> P) {
    for (int k = 0; k < most_corrections; ++k) {
      const Vector y = system_.solve(left_of(P));
      for (std::size_t i = 0; i < rows_.size(); ++i) {
        P[i] =
            nearest_in_cone(P[i] - derivatives_[i] * system_.relative_velocity(i, y), rows_[i].n, rows_[i].friction).P;
      }
      if (keep(P) <= balanced) return true;
    }
    return false;
  }

  /// Returns whether balance was found.
  bool newton(double share, Vector& y) {
    Vector gradient, next_gradient;
    std::vector<Vec3> P(rows_.size());
    double phi = evaluate(y, share, gradient, P);
    for (int k = 0; k < most_newton_steps_of_balance; ++k) {
      const double size = system_.greatest_speed(system_.response(gradient));
      if (size <= newton_tolerance * greatest_) break;
      mark(Mark::balance_step);
      mark(Mark::contact_row, rows_.size());
      system_.factor(share, derivatives_);
      const Vector step = system_.solve(gradient);
      const double slope = gradient.dot(step);
      double part = 1;
      bool better = false;
      for (int halving = 0; halving < most_halvings_of_balance && !better; ++halving, part /= 2) {
        const Vector next = y - part * step;
        const double next_phi = evaluate(next, share, next_gradient, P);
        better = next_phi <= phi - armijo * part * slope ||
                 system_.greatest_speed(system_.response(next_gradient)) <= size / 2;
        if (!better) continue;
        y = next;
        phi = next_phi;
        gradient = next_gradient;
      }
      if (!better) {
        phi = evaluate(y, share, gradient, P);
        break;
      }
    }
    if (keep(P) > nearly) return false;
    system_.factor(share, derivatives_);
    return correct(P);
  }

  /// Whether a motion proves that no impulses balance the loads.
  bool falls(const Vector& motion) const {
    if (!(load_.dot(motion) > 0)) return false;
    const double within = parts_within * system_.greatest_speed(motion);
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const Vec3 u = system_.relative_velocity(i, motion);
      const double u_n = rows_[i].n.dot(u);
      if (u_n < rows_[i].friction * (u - u_n * rows_[i].n).norm() - within) return false;
    }
    return true;
  }

  std::optional<Vector> minimise() {
    last_ = system_.zero();
    for (double share = first_share; share >= last_share; share *= share_ratio) {
      Vector y = last_;
      if (newton(share, y)) return std::nullopt;
      if (falls(y - last_)) return y - last_;
      last_ = y;
    }
    return std::nullopt;
  }

  std::vector<ContactRow>& rows_;
  TwistSystem system_;
  Vector load_, last_;
  double greatest_ = 0, least_ = 0;
  std::vector<double> stiffness_;
  std::vector<Mat3> derivatives_;
  std::vector<Vec3> best_;
};

}  // namespace

std::optional<std::vector<Twist>> balance(std::vector<ContactRow>& rows, const std::vector<Mobility>& bodies,
                                          std::vector<Twist>& twists) {
  return Search(rows, bodies, twists).run(twists);
}

}  // namespace touchstone::fast::contact
