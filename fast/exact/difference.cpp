#include "fast/exact/difference.h"

#include <algorithm>
#include <utility>

#include "fast/exact/rotation.h"
#include "fast/lin_canny/rotation.h"
#include "model/infinity.h"

namespace touchstone::fast::exact {
namespace {

using Matrix = std::array<Vector, 3>;

Vector times(const Matrix& M, const Vector& v) { return {dot(M[0], v), dot(M[1], v), dot(M[2], v)}; }

Vector column(const Matrix& M, int j) {
  const auto pick = [j](const Vector& row) { return j == 0 ? row.x : j == 1 ? row.y : row.z; };
  return {pick(M[0]), pick(M[1]), pick(M[2])};
}

Matrix times(const Matrix& L, const Matrix& M) {
  Matrix product;
  for (std::size_t i = 0; i < 3; ++i) {
    product[i] = {dot(L[i], column(M, 0)), dot(L[i], column(M, 1)), dot(L[i], column(M, 2))};
  }
  return product;
}

}  // namespace

Difference::Posed::Posed(const PosedPoints& solid) : points_(solid.points), R_(Mat3::Identity()) {
  M_ = {Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}};
  D_ = 1;
  for (const Pose& X : solid.poses) {
    const ScaledRotation turn = scaled_rotation(X.q_WB);
    const Vector moved = times(M_, vector(X.p_WB)) + t_;
    t_ = turn.squared_length * moved;
    M_ = times(M_, turn.rows);
    D_ = D_ * turn.squared_length;
    R_ = R_ * lin_canny::rotation(X.q_WB);
  }
  for (const Vec3& v : points_) radius_ = std::max(radius_, v.lpNorm<1>());
}

void Difference::Posed::set_scale(const Dyadic& scale) {
  for (Vector& row : M_) row = scale * row;
  t_ = scale * t_;
}

const Vector& Difference::Posed::scaled_point(int i) {
  const auto known = known_.find(i);
  if (known != known_.end()) return known->second;
  return known_.emplace(i, times(M_, vector(points_[static_cast<std::size_t>(i)])) + t_).first->second;
}

/// n·R v in doubles for each v, times a common factor > 0. n is cut to 2^-52 of its length; the error of R is 12u, two
/// of them and their product 12 + 12 + 3·3 = 33u; Rᵀn adds 5.2u, the products with v 3.1u|v|: together less than
/// 45u|n||v|, and |n| ≤ √3. The bound is taken as 128u, with room for its own rounding and for underflow.
std::vector<double> Difference::Posed::heights(const Vector& n, double& error) const {
  const Vec3 n_B = R_.transpose() * direction(n);
  std::vector<double> heights(points_.size());
  for (std::size_t i = 0; i < points_.size(); ++i) heights[i] = n_B.dot(points_[i]);
  error = radius_ < 0x1p1000 ? 128 * u * radius_ + 0x1p-1000 : infinity;
  return heights;
}

int Difference::Posed::farthest(const Vector& n) {
  if (points_.size() == 1) return 0;
  double error = 0;
  const std::vector<double> height = heights(n, error);
  double highest = height.front();
  for (const double h : height) highest = std::max(highest, h);
  int best = -1;
  Dyadic best_height;
  for (std::size_t i = 0; i < height.size(); ++i) {
    if (height[i] < highest - 2 * error) continue;  // never if the error is infinite
    const int candidate = static_cast<int>(i);
    const Dyadic exact = dot(n, scaled_point(candidate));
    if (best >= 0 && (exact - best_height).sign() <= 0) continue;
    best = candidate;
    best_height = exact;
  }
  return best;
}

Difference::Difference(const PosedPoints& A, const PosedPoints& B) : A_(A), B_(B) {
  denominator_ = A_.denominator() * B_.denominator();
  const Dyadic scale_A = B_.denominator();
  const Dyadic scale_B = A_.denominator();
  A_.set_scale(scale_A);
  B_.set_scale(scale_B);
}

}  // namespace touchstone::fast::exact
