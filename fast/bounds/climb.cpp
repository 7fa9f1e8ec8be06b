#include "fast/bounds/climb.h"

#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include "fast/exact/rotation.h"
#include "fast/lin_canny/rotation.h"
#include "fast/mark.h"

namespace touchstone::fast {
namespace {

using lin_canny::Hull;

/// A computed r·s, with r a row of R and s a unit vector along an edge: the error of R is 36u, that of the vector 5u,
/// and the three products and two sums of numbers whose magnitudes sum to at most 1 round by 3.1u: 44.1u, and terms of
/// second order.
constexpr double slope_error = 48 * u;

/// Row `axis` of R, times the |q|² of all poses, exactly.
exact::Vector exact_row(std::span<const Pose> poses, int axis) {
  exact::Vector row{axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0};
  for (const Pose& X : poses) {
    const exact::ScaledRotation R = exact::scaled_rotation(X.q_WB);
    row = row.x * R.rows[0] + row.y * R.rows[1] + row.z * R.rows[2];
  }
  return row;
}

std::tuple<double, double, double> coordinates(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

/// Climbs along one axis of W, or against it.
class Uphill {
 public:
  Uphill(const Hull& hull, std::span<const Pose> poses, const Mat3& R, int axis, int sign)
      : hull_(hull),
        poses_(poses),
        direction_(sign * R.row(axis).transpose()),
        floats_(direction_),
        axis_(axis),
        sign_(sign) {}

  /// Whether `there` is higher than its neighbour `here`.
  bool higher(int there, int here) {
    const Vec3 along = hull_.vertex(there) - hull_.vertex(here);
    const double slope = direction_.dot(along / along.norm());
    if (hull_.fits_doubles() && std::abs(slope) > slope_error) return slope > 0;
    if (!row_) {
      mark(Mark::climb_exact);
      row_ = exact_row(poses_, axis_);
    }
    const Vec3 &to = hull_.vertex(there), &from = hull_.vertex(here);
    const int rises = sign_ * dot(*row_, exact::vector(to) - exact::vector(from)).sign();
    return rises != 0 ? rises > 0 : coordinates(to) > coordinates(from);
  }

  /// A neighbour that is higher; -1 if there is none. Floats decide first.
  int higher_neighbour(int vertex) {
    for (const Hull::Spokes& some : hull_.spokes(vertex)) {
      const lin_canny::FloatDirection::Slopes slopes = floats_.slopes(some);
      for (std::size_t lane = 0; lane < Hull::Spokes::lanes; ++lane) {
        if (slopes[lane] < -floats_.error()) continue;
        const int there = some.other[lane];
        if (slopes[lane] > floats_.error() || higher(there, vertex)) return there;
      }
    }
    return -1;
  }

  int top(int vertex) {
    for (int next; (next = higher_neighbour(vertex)) >= 0; vertex = next) mark(Mark::climb_step);
    return vertex;
  }

 private:
  const Hull& hull_;
  std::span<const Pose> poses_;
  Vec3 direction_;
  lin_canny::FloatDirection floats_;
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
