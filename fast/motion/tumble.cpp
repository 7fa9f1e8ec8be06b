#include "fast/motion/tumble.h"

#include <algorithm>
#include <cmath>

#include "fast/lin_canny/rotation.h"

namespace touchstone::fast::motion {
namespace {


constexpr std::size_t most_steps = 1 << 13;
constexpr double nothing_known = 2;

/// A with δω' = A δω.
Mat3 linearised(const Vec3& c, const Vec3& w) {
  Mat3 A;
  A << 0, c[0] * w[2], c[0] * w[1],  //
      c[1] * w[2], 0, c[1] * w[0],   //
      c[2] * w[1], c[2] * w[0], 0;
  return A;
}

/// ≥ ‖M‖₂: the root of the greatest column sum times the greatest row sum.
double norm(const Mat3& M) {
  const Mat3 sizes = M.cwiseAbs();
  return std::sqrt(sizes.colwise().sum().maxCoeff() * sizes.rowwise().sum().maxCoeff());
}

/// The inverse of a matrix of determinant 1: Ψ' = A Ψ and tr A = 0.
Mat3 adjugate(const Mat3& M) {
  Mat3 inverse;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const int r = (j + 1) % 3, s = (j + 2) % 3, p = (i + 1) % 3, q = (i + 2) % 3;
      inverse(i, j) = M(r, p) * M(s, q) - M(r, q) * M(s, p);
    }
  }
  return inverse;
}

}  // namespace

Tumble::Tumble(const Vec3& c, double c_error, const Vec3& w_P, double w_error) : c_(c), c_error_(c_error) {
  int exponent = 0;
  const double greatest = w_P.lpNorm<Eigen::Infinity>();
  if (greatest > 0) std::frexp(greatest, &exponent);
  scale_ = std::ldexp(1.0, exponent);
  const Vec3 w = w_P / scale_;
  start_ = {1, 0, 0, 0, w[0], w[1], w[2]};
  injected_ = w_error * w.norm();
}

/// Powers of two for the length: the scaled terms are exact.
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

/// New in a step: the sums' rounding, 4u, and what the coefficients' error does, c_error |ω|² a unit of time. Within a
/// step Ψ and Ψ⁻¹ are what they are at its ends, give or take a half. The series of Ψ to order 12 is a bound's, not a
/// solution's: a percent is nothing.
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
  const Terms& x = taken.series[0];
  const double rate = Vec3(x[4], x[5], x[6]).norm();
  const double before = norm(growth_), inverse_before = norm(inverse_growth_);
  growth_ = once.lazyProduct(growth_).eval();
  inverse_growth_ = inverse_growth_.lazyProduct(adjugate(once)).eval();
  injected_ +=
      1.5 * std::max(inverse_before, norm(inverse_growth_)) * (4 * u * rate + c_error_ * rate * rate * taken.length);
  taken.w_error = 1.5 * std::max(before, norm(growth_)) * injected_;
  error_ += taken.w_error * taken.length + 16 * u;
  if (!(error_ < 0x1p-10) || steps_.size() >= most_steps) error_ = nothing_known;
  taken.error = error_;
}

Tumble::Terms Tumble::sum(const Step& step, double x) {
  Terms total = step.series[order];
  for (std::size_t k = order; k-- > 0;) {
    for (std::size_t i = 0; i < total.size(); ++i) total[i] = total[i] * x + step.series[k][i];
  }
  return total;
}

Tumble::Now Tumble::at(double tau) {
  const double time = tau * scale_;
  const auto end = [](const Step& s) { return s.from + s.length; };
  while (steps_.empty() || (end(steps_.back()) < time && error_ < nothing_known)) {
    Step next = steps_.empty() ? step(0, start_) : step(end(steps_.back()), sum(steps_.back(), 1));
    grow_errors(next);
    steps_.push_back(next);
  }
  const auto after = [&](double t, const Step& s) { return t < s.from; };
  const Step& now = *std::prev(std::upper_bound(steps_.begin() + 1, steps_.end(), time, after));
  if (end(now) < time) return {{}, Vec3::Zero(), nothing_known, nothing_known * scale_};
  const Terms x = sum(now, (time - now.from) / now.length);
  // τ itself rounds by u: the turn by |ω| τ u.
  const double late = 2 * u * time;
  return {{x[0], x[1], x[2], x[3]},
          scale_ * Vec3(x[4], x[5], x[6]),
          std::min(nothing_known, now.error + 2 * late),
          scale_ * (now.w_error + 2 * late)};
}

}  // namespace touchstone::fast::motion
