#include <algorithm>

#include "reference/equilibrium/loads.h"

namespace touchstone::reference {
namespace {

mpq_class one_and_square(double friction) { return 1 + mpq_class(friction) * mpq_class(friction); }

bool in_cone(const Triple& P, const LoadedBodies::Point& point) {
  const Triple N = triple(point.nhat_BA_W);
  const mpq_class p = dot(P, N);
  return sgn(p) >= 0 && dot(N, N) * dot(P, P) <= one_and_square(point.friction) * p * p;
}

bool in_dual_cone(const Triple& u, const LoadedBodies::Point& point) {
  const Triple N = triple(point.nhat_BA_W);
  const mpq_class U = dot(u, N), mu(point.friction);
  return sgn(U) >= 0 && one_and_square(point.friction) * U * U >= mu * mu * dot(N, N) * dot(u, u);
}

}  // namespace

bool proves_standing(const LoadedBodies& bodies, const std::vector<ExactVec3>& P_A_W) {
  if (P_A_W.size() != bodies.points.size()) return false;
  std::vector<Triple> P;
  for (const ExactVec3& each : P_A_W) P.push_back(triple(each));
  for (std::size_t k = 0; k < P.size(); ++k) {
    if (!in_cone(P[k], bodies.points[k])) return false;
  }
  const std::vector<ExactLoad> left = left_of(bodies, P);
  for (std::size_t i = 0; i < left.size(); ++i) {
    if (bodies.loads[i] && !left[i].is_zero()) return false;
  }
  return true;
}

bool proves_falling(const LoadedBodies& bodies, const std::vector<ExactVelocity>& motion) {
  if (motion.size() != bodies.loads.size()) return false;
  mpq_class work = 0;
  std::vector<std::array<Triple, 2>> twists;  // v and ω; fixed bodies do not move, whatever is said of them
  for (std::size_t i = 0; i < motion.size(); ++i) {
    std::array<Triple, 2>& twist = twists.emplace_back();
    if (!bodies.loads[i]) continue;
    twist = {triple(motion[i].v_WBcm), triple(motion[i].w_WB)};
    work += dot(triple(bodies.loads[i]->force_W), twist[0]) + dot(triple(bodies.loads[i]->torque_W), twist[1]);
  }
  if (sgn(work) <= 0) return false;
  const auto velocity = [&](int body, const Vec3& arm) {
    return plus(twists[index(body)][0], cross(twists[index(body)][1], triple(arm)));
  };
  return std::ranges::all_of(bodies.points, [&](const LoadedBodies::Point& point) {
    return in_dual_cone(minus(velocity(point.a, point.arm_A_W), velocity(point.b, point.arm_B_W)), point);
  });
}

}  // namespace touchstone::reference
