#include "fast/contact/active_set.h"

#include "fast/contact/cross_matrix.h"
#include "fast/contact/least_norm.h"

namespace touchstone::fast::contact {
namespace {

/// Velocity of the body at `at` per unit impulse at `by`.
Mat3 response(const Mobility& body, const Vec3& at, const Vec3& by) {
  return body.inverse_mass * Mat3::Identity() - cross_matrix(at) * body.inverse_inertia * cross_matrix(by);
}

/// Velocity u at one contact per unit impulse at another.
Mat3 coupling(const ContactRow& at, const ContactRow& by, const std::vector<Mobility>& bodies) {
  Mat3 K = Mat3::Zero();
  if (at.a == by.a) K += response(bodies[static_cast<std::size_t>(at.a)], at.arm_A, by.arm_A);
  if (at.b == by.b) K += response(bodies[static_cast<std::size_t>(at.b)], at.arm_B, by.arm_B);
  if (at.a == by.b) K -= response(bodies[static_cast<std::size_t>(at.a)], at.arm_A, by.arm_B);
  if (at.b == by.a) K -= response(bodies[static_cast<std::size_t>(at.b)], at.arm_B, by.arm_A);
  return K;
}

}  // namespace

void solve_active_set(std::vector<ContactRow>& rows, const std::vector<Mobility>& bodies, std::vector<Twist>& twists) {
  std::vector<std::size_t> closed;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!rows[i].P.isZero(0)) closed.push_back(i);
  }
  const auto size = static_cast<Eigen::Index>(3 * closed.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
  Eigen::VectorXd rest = Eigen::VectorXd::Zero(size);
  for (std::size_t i = 0; i < closed.size(); ++i) {
    const ContactRow& row = rows[closed[i]];
    const auto at = static_cast<Eigen::Index>(3 * i);
    const Vec3 u = relative_velocity(row, twists);
    const double P_n = row.n.dot(row.P);
    const Vec3 P_t = row.P - P_n * row.n;
    const Mat3 normal = row.n * row.n.transpose(), across = Mat3::Identity() - normal;
    const bool slips = !sticks(row);
    // All equations are between velocities: the slip condition, an equation between impulses, is multiplied by K_tt.
    const Mat3 of_velocity = slips ? normal : Mat3::Identity();
    for (std::size_t j = 0; j < closed.size(); ++j) {
      const auto column = static_cast<Eigen::Index>(3 * j);
      matrix.block<3, 3>(at, column) = of_velocity * coupling(row, rows[closed[j]], bodies);
    }
    rest.segment<3>(at) = row.least_u_n * row.n - of_velocity * u;
    if (!slips) continue;
    // P_t stays the same multiple of P_n: dP_t = (P_t/P_n) dP_n.
    const Vec3 d = P_n > 0 ? Vec3(P_t / P_n) : Vec3::Zero();
    matrix.block<3, 3>(at, at) += row.K_tt * (across - d * row.n.transpose());
  }
  if (closed.empty()) return;
  const Eigen::VectorXd dP = least_norm_solution(matrix, rest);
  for (std::size_t i = 0; i < closed.size(); ++i) {
    apply_impulse(rows[closed[i]], dP.segment<3>(static_cast<Eigen::Index>(3 * i)), bodies, twists);
    rows[closed[i]].P += dP.segment<3>(static_cast<Eigen::Index>(3 * i));
  }
}

}  // namespace touchstone::fast::contact
