#include "fast/bounds/climb.h"

#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include "fast/exact/vector.h"
#include "fast/lin_canny/rotation.h"
#include "fast/mark.h"

namespace touchstone::fast {
namespace {

using exact::Dyadic;
using lin_canny::Hull;

/// A computed r·s, with r a row of R and s a unit spoke: the error of R is 36u, that of the spoke 5u, and the three
/// products and two sums of numbers whose magnitudes sum to at most 1 round by 3.1u: 44.1u, and terms of second order.
constexpr double slope_error = 48 * u;

struct ExactQuaternion {
  Dyadic w, x, y, z;
};

ExactQuaternion product(const ExactQuaternion& a, const Quaternion& b) {
  return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
          a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

/// Row `axis` of |q|² R(q/|q|), exact; q is the product of the poses' quaternions.
exact::Vector exact_row(std::span<const Pose> poses, int axis) {
  ExactQuaternion q{1.0, 0.0, 0.0, 0.0};
  for (const Pose& X : poses) q = product(q, X.q_WB);
  const Dyadic two(2.0);
  const Dyadic ww = q.w * q.w, xx = q.x * q.x, yy = q.y * q.y, zz = q.z * q.z;
  if (axis == 0) return {ww + xx - yy - zz, two * (q.x * q.y - q.w * q.z), two * (q.x * q.z + q.w * q.y)};
  if (axis == 1) return {two * (q.x * q.y + q.w * q.z), ww - xx + yy - zz, two * (q.y * q.z - q.w * q.x)};
  return {two * (q.x * q.z - q.w * q.y), two * (q.y * q.z + q.w * q.x), ww - xx - yy + zz};
}

std::tuple<double, double, double> coordinates(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

/// Climbs along one axis of W, or against it.
class Uphill {
 public:
  Uphill(const Hull& hull, std::span<const Pose> poses, const Mat3& R, int axis, int sign)
      : hull_(hull), poses_(poses), direction_(sign * R.row(axis).transpose()), axis_(axis), sign_(sign) {}

  bool higher(const Hull::Spoke& spoke, int from) {
    const double slope = direction_.dot(spoke.away);
    if (hull_.fits_doubles() && std::abs(slope) > slope_error) return slope > 0;
    if (!row_) {
      mark(Mark::climb_exact);
      row_ = exact_row(poses_, axis_);
    }
    const Vec3& there = hull_.vertex(spoke.other);
    const Vec3& here = hull_.vertex(from);
    const int rises = sign_ * dot(*row_, exact::vector(there) - exact::vector(here)).sign();
    return rises != 0 ? rises > 0 : coordinates(there) > coordinates(here);
  }

  int top(int vertex) {
    for (const Hull::Spoke* s = hull_.spokes_begin(vertex); s != hull_.spokes_end(vertex);) {
      if (higher(*s, vertex)) {
        mark(Mark::climb_step);
        vertex = s->other;
        s = hull_.spokes_begin(vertex);
      } else {
        ++s;
      }
    }
    return vertex;
  }

 private:
  const Hull& hull_;
  std::span<const Pose> poses_;
  Vec3 direction_;
  int axis_;
  int sign_;
  std::optional<exact::Vector> row_;  ///< set once doubles could not decide
};

}  // namespace

Climb::Climb(std::shared_ptr<const lin_canny::Hull> hull, int start) : hull_(std::move(hull)) { six_.fill(start); }

const Climb::Six& Climb::climb(std::span<const Pose> poses, const Mat3& R) {
  mark(Mark::climb);
  for (int k = 0; k < 6; ++k) {
    int& vertex = six_[static_cast<std::size_t>(k)];
    vertex = Uphill(*hull_, poses, R, k % 3, k < 3 ? 1 : -1).top(vertex);
  }
  return six_;
}

}  // namespace touchstone::fast
