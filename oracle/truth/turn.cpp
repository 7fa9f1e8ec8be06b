#include "oracle/truth/turn.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace touchstone::oracle {
namespace {

constexpr Real steps_per_piece = 256;
constexpr Real most_pieces = 256;

Real pieces(const Point& from, const Point& until, Real seconds) {
  const Real fastest = std::max(from.norm(), until.norm());
  return 1 + std::max(fastest * seconds, std::sqrt((until - from).norm() * seconds));
}

Eigen::Quaternion<Real> rotation(const Point& angle) {
  const Real size = angle.norm();
  if (!(size > 0)) return Eigen::Quaternion<Real>::Identity();
  return Eigen::Quaternion<Real>(Eigen::AngleAxis<Real>(size, angle / size));
}

}  // namespace

// Each step is exp(θ) with the first two terms of the Magnus expansion (Magnus 1954; Blanes, Casas, Oteo, Ros 2009):
// with a = h ω in the middle of the step and b = h² ω', θ = a − (a × b)/12.
//
// The rest. With s = h/2, w = ω in the middle and α = ω', exp(θ(s)) is the rotation from −s to s if θ' = 2 (x cot x) w
// + s α × θ, where x cot x is a series of θ× with x = |θ|/2 (the angular velocities at both ends, brought to the middle
// of the rotation). So the coefficients of θ are at most those of y, y' = 2 W f(y/2) + s A y with f(x) = 2 − x cot x,
// whose coefficients are positive. At S = min(1/(2W), 1/√(2A)) y < 1.7: otherwise 1.7 ≤ 2 W S f(0.85) + A S² 1.7/2 ≤
// 1.254 + 0.425. θ is odd, and the terms of first and third order are the two above. So the rest is at most 1.7 (s/S)⁵.
// Steps are so short that h W and h √A are at most 2⁻⁸, and s/S too: 1.7 · 2⁻⁴⁰ a step, 2⁻³¹ for the 256 of a piece.
// The rounding of long doubles is far below.
Matrix turn(const Point& from, const Point& until, Real seconds) {
  const Real steps = std::ceil(steps_per_piece * pieces(from, until, seconds)), h = seconds / steps;
  const Point change = (until - from) / steps, b = h * change;
  Eigen::Quaternion<Real> turned = Eigen::Quaternion<Real>::Identity();
  for (Real step = 0; step < steps; ++step) {
    const Point a = h * (from + (step + 0.5L) * change);
    turned = rotation(a - a.cross(b) / 12) * turned;
  }
  return turned.normalized().toRotationMatrix();
}

Real turn_error(const Point& from, const Point& until, Real seconds) { return 0x1p-30L * pieces(from, until, seconds); }

bool is_short_turn(const Point& from, const Point& until, Real seconds) {
  return pieces(from, until, seconds) <= most_pieces;
}

}  // namespace touchstone::oracle
