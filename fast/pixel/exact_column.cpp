#include "fast/pixel/exact_column.h"

#include "fast/exact/rotation.h"
#include "fast/mark.h"

namespace touchstone::fast::pixel {
namespace {

using exact::Dyadic;
using exact::Vector;

Fraction operator-(const Fraction& a, const Fraction& b) { return {a.num * b.den - b.num * a.den, a.den * b.den}; }
bool less(const Fraction& a, const Fraction& b) { return (a - b).num.sign() < 0; }

/// From the innermost pose out: p = P/D becomes (|q|² R P + |q|² D t)/(|q|² D).
Vector place(const Vec3& p, const std::vector<Pose>& poses) {
  Vector P = exact::vector(p);
  Dyadic D = 1.0;
  for (std::size_t k = poses.size(); k-- > 0;) {
    const exact::ScaledRotation turn = exact::scaled_rotation(poses[k].q_WB);
    D = D * turn.squared_length;
    P = turn * P + D * exact::vector(poses[k].p_WB);
  }
  return P;
}

/// x.lo − √x.spread ≤ y.hi + √y.spread, decided by squaring twice.
bool starts_before_end(const Column& x, const Column& y) {
  const Fraction gap = x.lo - y.hi;
  if (gap.num.sign() <= 0) return true;
  const Fraction squared{gap.num * gap.num, gap.den * gap.den};
  const Fraction beyond = squared - x.spread - y.spread;
  if (beyond.num.sign() <= 0) return true;
  const Dyadic four = 4.0;
  return !less({four * x.spread.num * y.spread.num, x.spread.den * y.spread.den},
               {beyond.num * beyond.num, beyond.den * beyond.den});
}

}  // namespace

bool meet(const Column& a, const Column& b) { return starts_before_end(a, b) && starts_before_end(b, a); }

ExactPart::ExactPart(const Part& part) : D_(1.0) {
  for (const Pose& pose : part.poses) D_ = D_ * exact::scaled_rotation(pose.q_WB).squared_length;
  if (const auto* sphere = std::get_if<Sphere>(&part.shape)) {
    centre_ = place(Vec3::Zero(), part.poses);
    radius_ = sphere->radius;
    return;
  }
  const auto& polytope = std::get<Polytope>(part.shape);
  std::vector<Vector> placed;
  for (const Vec3& v : polytope.vertices) placed.push_back(place(v, part.poses));
  const auto at = [&](int i) -> const Vector& { return placed[static_cast<std::size_t>(i)]; };
  for (const std::vector<int>& face : polytope.faces) {
    Vector normal;
    for (std::size_t k = 1; k + 1 < face.size(); ++k) {
      normal = normal + cross(at(face[k]) - at(face[0]), at(face[k + 1]) - at(face[0]));
    }
    sides_.push_back({normal, dot(normal, at(face[0]))});
  }
}

std::optional<Column> ExactPart::above(const Dyadic& x, const Dyadic& y) const {
  mark(Mark::pixel_exact);
  const Dyadic Dx = D_ * x;
  const Dyadic Dy = D_ * y;
  if (radius_ > 0) {
    const Dyadic r = D_ * Dyadic(radius_);
    const Dyadic squared = r * r - (Dx - centre_.x) * (Dx - centre_.x) - (Dy - centre_.y) * (Dy - centre_.y);
    if (squared.sign() < 0) return std::nullopt;
    const Fraction middle{centre_.z, D_};
    return Column{middle, middle, {squared, D_ * D_}};
  }
  std::optional<Fraction> lo;
  std::optional<Fraction> hi;
  for (const Side& side : sides_) {
    const Dyadic room = side.offset - side.normal.x * Dx - side.normal.y * Dy;  // normal.z · D z ≤ room
    const int up = side.normal.z.sign();
    if (up == 0 && room.sign() < 0) return std::nullopt;
    const Fraction at = up < 0 ? Fraction{-room, -side.normal.z * D_} : Fraction{room, side.normal.z * D_};
    if (up > 0 && (!hi || less(at, *hi))) hi = at;
    if (up < 0 && (!lo || less(*lo, at))) lo = at;
  }
  if (less(*hi, *lo)) return std::nullopt;
  return Column{*lo, *hi, {0.0, 1.0}};
}

}  // namespace touchstone::fast::pixel
