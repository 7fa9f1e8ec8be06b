#include "fast/motion/tumble.h"

#include <algorithm>
#include <cmath>

#include "fast/lin_canny/rotation.h"
#include "fast/mark.h"
#include "fast/motion/quaternion.h"
#include "model/infinity.h"

namespace touchstone::fast::motion {
namespace {

/// No two unit vectors differ by more.
constexpr double nothing_known = 2;

/// A with δω' = A δω.
Mat3 linearised(const Vec3& c, const Vec3& w) {
  Mat3 A;
  A << 0, c[0] * w[2], c[0] * w[1],  //
      c[1] * w[2], 0, c[1] * w[0],   //
      c[2] * w[1], c[2] * w[0], 0;
  return A;
}

/// √(Σ weight_k ω_k²), where the motion has it greatest. ω_k² − (c_k/c_i) ω_i² is constant, with i the middle axis, so
/// that is where ω_i² is 0 or greatest, and another ω_k² is 0. Where all moments are equal, ω is constant.
double greatest_norm(const Vec3& weights, const Vec3& c, const Vec3& w) {
  int i = 0;
  for (int axis = 1; axis < 3; ++axis) {
    if (c[(axis + 1) % 3] * c[(axis + 2) % 3] > c[(i + 1) % 3] * c[(i + 2) % 3]) i = axis;
  }
  const Vec3 from = w.cwiseAbs2();
  if (c.isZero(0)) return std::sqrt(weights.dot(from));
  double to_greatest = infinity;
  for (int k = 0; k < 3; ++k) {
    if (k != i) to_greatest = std::min(to_greatest, std::abs(c[i] / c[k]) * from[k]);
  }
  const auto sum_after = [&](double gained) {
    double sum = 0;
    for (int k = 0; k < 3; ++k) {
      const double gains = k == i ? gained : -std::abs(c[k] / c[i]) * gained;
      sum += weights[k] * std::max(0.0, from[k] + gains);
    }
    return sum;
  };
  return std::sqrt(std::max(sum_after(-from[i]), sum_after(to_greatest)));
}

/// An error of ω grows at most at the greatest eigenvalue of A's symmetric part. That has no trace, and m_k = (c_i +
/// c_j) ω_k/2 off its diagonal, so the eigenvalue is at most √(4/3 Σ m_k²).
double greatest_growth(const Vec3& c, const Vec3& w) {
  const Vec3 m = Vec3(c[1] + c[2], c[2] + c[0], c[0] + c[1]) / 2;
  return greatest_norm(4.0 / 3 * m.cwiseAbs2(), c, w);
}

/// Beyond the first order, and for the percents of Φ.
constexpr double margin = 1.125;

/// At least the longest half axis of the ellipsoid, √λ with λ the greatest eigenvalue of S; at most 15 % more. λ⁴ ≤ tr
/// S⁴.
double longest_axis(const Mat3& S) { return std::sqrt(std::sqrt(Mat3(S.lazyProduct(S)).norm())); }

/// At least e^x, by at most a factor of e^(x²/120), for x from 0 to 8; infinite above. std::exp rounds by machine.
double above_exp(double x) {
  if (!(x < 8)) return infinity;
  double power = 1 / (1 - x / 64);
  for (int k = 0; k < 6; ++k) power *= power;
  return power;
}

}  // namespace

Tumble::Tumble(const Vec3& c, double c_error, const Vec3& w_P, double w_error) : c_(c), c_error_(c_error) {
  int exponent = 0;
  const double greatest = w_P.lpNorm<Eigen::Infinity>();
  if (greatest > 0) std::frexp(greatest, &exponent);
  scale_ = std::ldexp(1.0, exponent);
  const Vec3 w = w_P / scale_;
  start_ = {1, 0, 0, 0, w[0], w[1], w[2]};
  spread_ = (w_error * w_error) * w.squaredNorm() * Mat3::Identity();
  period_ = period(c, c_error, w, w_error);
  greatest_ = {greatest_norm(Vec3::Ones(), c, w), greatest_growth(c, w)};
}

/// The length is a power of two: the scaled terms are exact.
Tumble::Step Tumble::step(double from, const Terms& start) {
  Step taken;
  taken.from = from;
  auto& a = taken.series;
  a[0] = start;
  for (std::size_t k = 0; k < order; ++k) {
    Terms next{};
    for (std::size_t j = 0; j <= k; ++j) {
      const Terms& x = a[j];
      const Terms& y = a[k - j];
      next[0] -= (x[1] * y[4] + x[2] * y[5]) + x[3] * y[6];
      next[1] += (x[0] * y[4] + x[2] * y[6]) - x[3] * y[5];
      next[2] += (x[0] * y[5] + x[3] * y[4]) - x[1] * y[6];
      next[3] += (x[0] * y[6] + x[1] * y[5]) - x[2] * y[4];
      next[4] += x[5] * y[6];
      next[5] += x[6] * y[4];
      next[6] += x[4] * y[5];
    }
    const double n = static_cast<double>(k + 1);
    for (std::size_t i = 0; i < 4; ++i) a[k + 1][i] = next[i] / (2 * n);
    for (std::size_t i = 0; i < 3; ++i) a[k + 1][4 + i] = c_[static_cast<Eigen::Index>(i)] * next[4 + i] / n;
  }
  const auto greatest = [&](std::size_t k) {
    double most = 0;
    for (const double x : a[k]) most = std::max(most, std::abs(x));
    return most;
  };
  taken.length = 8;
  double last = greatest(order), before = greatest(order - 1);
  for (int k = 0; k < order; ++k) last *= taken.length;
  for (int k = 0; k + 1 < order; ++k) before *= taken.length;
  for (; !(last <= u / 8 && before <= u / 8) && taken.length > 0x1p-20; taken.length /= 2) {
    last *= 0x1p-20;
    before *= 0x1p-19;
  }
  double power = 1;
  for (auto& terms : a) {
    for (double& x : terms) x *= power;
    power *= taken.length;
  }
  return taken;
}

/// What is new in ω's error a while after a step's start, without its growth: the rounding of the sums, 4u, and the
/// effect of the coefficients' error, c_error |ω|² per unit of time.
double Tumble::new_error(double time) const { return greatest_.rate * (4 * u + c_error_ * greatest_.rate * time); }

/// The series of Φ to order 12 serves a bound, not a solution: an error of a percent does not matter.
void Tumble::grow_errors(Step& taken) {
  constexpr std::size_t enough = 12;
  std::array<Mat3, enough + 1> A, P;
  P[0].setIdentity();
  for (std::size_t k = 0; k < enough; ++k) {
    const Terms& x = taken.series[k];
    A[k] = taken.length * linearised(c_, {x[4], x[5], x[6]});
    P[k + 1].setZero();
    for (std::size_t j = 0; j <= k; ++j) P[k + 1] += A[j].lazyProduct(P[k - j]);
    P[k + 1] /= static_cast<double>(k + 1);
  }
  Mat3 once = P[enough];
  for (std::size_t k = enough; k-- > 0;) once += P[k];
  const double before = taken.w_error_before = longest_axis(spread_);
  spread_ = once.lazyProduct(spread_).lazyProduct(once.transpose()).eval();
  const double added = new_error(taken.length) * above_exp(greatest_.growth * taken.length);
  const double k = std::min(std::sqrt(spread_.trace() / 3) / added, 16 + static_cast<double>(steps_.size()));
  if (k > 0) spread_ *= 1 + 1 / k;
  spread_ += (1 + k) * (added * added) * Mat3::Identity();
  taken.w_error = margin * std::max(before, longest_axis(spread_));
  taken.error_before = error_;
  error_ += turn_error_after(taken, taken.length);
  if (!(error_ < 0x1p-10)) error_ = nothing_known;
  taken.error = error_;
}

/// The error of ω a while after a step's start.
double Tumble::w_error_after(const Step& step, double time) const {
  return std::min(step.w_error, margin * (step.w_error_before + new_error(time)) * above_exp(greatest_.growth * time));
}

/// What is added to the error of the rotation: the integral of that of ω. The trapezoid is above the convex
/// exponential.
double Tumble::turn_error_after(const Step& step, double time) const {
  const double grown = (1 + above_exp(greatest_.growth * time)) / 2;
  return std::min(step.w_error, margin * (step.w_error_before + new_error(time)) * grown) * time + 16 * u;
}

Tumble::Terms Tumble::sum(const Step& step, double x) {
  Terms total = step.series[order];
  for (std::size_t k = order; k-- > 0;) {
    for (std::size_t i = 0; i < total.size(); ++i) total[i] = total[i] * x + step.series[k][i];
  }
  return total;
}

/// In units of scale_.
Tumble::Now Tumble::within(double time) {
  const auto end = [](const Step& s) { return s.from + s.length; };
  while (steps_.empty() || end(steps_.back()) < time) {
    Step next = steps_.empty() ? step(0, start_) : step(end(steps_.back()), sum(steps_.back(), 1));
    mark(Mark::tumble_step);
    grow_errors(next);
    steps_.push_back(next);
  }
  const auto after = [](double t, const Step& s) { return t < s.from; };
  const Step& now = *std::prev(std::upper_bound(steps_.begin() + 1, steps_.end(), time, after));
  const double since = time - now.from, w_error = w_error_after(now, since);
  const double error = std::min(now.error, now.error_before + turn_error_after(now, since));
  const Terms x = sum(now, since / now.length);
  return {{x[0], x[1], x[2], x[3]}, {x[4], x[5], x[6]}, error, w_error};
}

/// By repeated squaring: each squaring doubles the error and adds 16u, and each product adds 16u.
Quaternion Tumble::turn_in(double periods) {
  Quaternion turn;
  for (std::size_t k = 0; periods >= 1; ++k) {
    if (k == turns_.size()) turns_.push_back(unit(product(turns_[k - 1], turns_[k - 1])));
    const double half = std::floor(periods / 2);
    if (periods - 2 * half == 1) turn = product(turns_[k], turn);
    periods = half;
  }
  return turn;
}

/// τ, its whole periods, and the remainder round by less than 4u of τ; the rotation by |ω| times that. Within a motion
/// |ω|² at most doubles (ballistic_motion.cpp), and |ω'| is below 2|ω|²/√3. The period's error affects how far the body
/// rotates in a period, and when the last one begins.
Tumble::Now Tumble::at(double tau) {
  const double time = tau * scale_, late = 4 * u * time;
  constexpr double most = 0x1p53;  // so late that doubles cannot tell the phase within a period
  const double periods = std::min(std::floor(time / period_.length), most);
  Now now = within(periods < most ? std::max(0.0, time - periods * period_.length) : 0);
  double error = now.error + 2 * late, w_error = now.w_error + 2 * late;
  constexpr double moments = 16;  // two steps, and the time between two evaluations
  if (time + moments > period_.length && turns_.empty()) {
    const Now whole = within(period_.length);
    turns_.push_back(unit(whole.q_P0P));
    turn_error_ = whole.error + 48 * u;
    jump_ = (whole.w_P - Vec3(start_[4], start_[5], start_[6])).norm();
  }
  if (periods > 0) {
    now.q_P0P = product(turn_in(periods), now.q_P0P);
    const double rate = Vec3(start_[4], start_[5], start_[6]).norm();
    error += periods * (turn_error_ + 3 * rate * period_.error);
    w_error += periods * 1.25 * rate * rate * period_.error;
  }
  if (!(error < 0x1p-10)) error = w_error = nothing_known;
  // Twice the new errors of a step of 8 units, for two evaluations on either side of a step's end; the rounding of
  // time; and the effect of another order of multiplying the rotations of whole periods.
  const double computed_error = 128 * u + 2 * late + 48 * u * periods, computed_w_error = 2 * computed_error + jump_;
  return {now.q_P0P, scale_ * now.w_P, error, scale_ * w_error, computed_error, scale_ * computed_w_error};
}

bool Tumble::follows(double tau) const { return std::isfinite(period_.error) || tau * scale_ <= period_.length; }

}  // namespace touchstone::fast::motion
