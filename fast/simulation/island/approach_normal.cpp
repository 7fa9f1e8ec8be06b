#include "fast/simulation/island/approach_normal.h"

#include <algorithm>
#include <vector>

#include "fast/contact/parting.h"
#include "fast/lin_canny/parting_normals.h"
#include "fast/simultaneous/nonnegative.h"

namespace touchstone::fast::simulation {
namespace {

constexpr double one_direction = 0x1p-20;  // difference of normals, as of one region (simultaneous_impact.cpp)
constexpr double slides_past = 0x1p-20;    // of the speed: a slower approach is not told from none
// Of the sizes. At a gap or overlap d the supporting planes of touching features have moved apart or together by at
// most d. Up to a gap of 2⁻³⁴ of the sizes `parting` finds no direction from the closest points. Twice that, and as
// much for an overlap.
constexpr double ties = 0x1p-32;

/// The extreme rays of N, and perhaps some more: the normals of the separating axis theorem that tie for the widest.
std::vector<Vec3> separating_normals(const contact::Part& A, const contact::Part& B) {
  struct Candidate {
    Vec3 n;
    double apart;
  };
  std::vector<Candidate> all;
  double widest = -infinity;
  lin_canny::any_parting_normal(A.core, B.core, [&](const Vec3& n, const lin_canny::FeaturePair&) {
    all.push_back({n, contact::apart(A, B, n)});
    widest = std::max(widest, all.back().apart);
    return false;
  });
  std::vector<Vec3> tied;
  for (const Candidate& candidate : all) {
    if (candidate.apart >= widest - ties * (A.convex->reach + B.convex->reach)) tied.push_back(candidate.n);
  }
  return tied;
}

}  // namespace

std::optional<Vec3> approach_normal(const contact::Part& A, const contact::Part& B, const Vec3& u) {
  if (A.is_ball() || B.is_ball()) return {};
  const std::vector<Vec3> rays = separating_normals(A, B);
  const auto is_first = [&](const Vec3& n) { return (n - rays.front()).norm() <= one_direction; };
  if (std::ranges::all_of(rays, is_first)) return {};
  if (std::ranges::any_of(rays, [&](const Vec3& n) { return !(n.dot(u) < -slides_past * u.norm()); })) return {};
  Eigen::MatrixXd N(3, static_cast<Eigen::Index>(rays.size()));
  for (std::size_t i = 0; i < rays.size(); ++i) N.col(static_cast<Eigen::Index>(i)) = rays[i];
  const Vec3 projection = N * simultaneous::nonnegative_least_squares(N, -u);
  return projection.normalized();
}

}  // namespace touchstone::fast::simulation
