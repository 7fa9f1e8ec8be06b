#include "fast/contact/row.h"

#include <cmath>

#include "fast/contact/cross_matrix.h"

namespace touchstone::fast::contact {
namespace {

constexpr double on_the_rim = 1 - 0x1p-20;

Mat3 response_at(const Mobility& body, const Vec3& arm) {
  const Mat3 r = cross_matrix(arm);
  return body.inverse_mass * Mat3::Identity() - r * body.inverse_inertia * r;
}

}  // namespace

void prepare(ContactRow& row, const std::vector<Mobility>& bodies) {
  const Mat3 K = response_at(bodies[index(row.a)], row.arm_A) + response_at(bodies[index(row.b)], row.arm_B);
  const Vec3 t = row.n.unitOrthogonal(), s = row.n.cross(t);
  row.K_n = K * row.n;
  row.K_nn = row.n.dot(row.K_n);
  const double tt = t.dot(K * t), ss = s.dot(K * s), ts = t.dot(K * s), half = (tt - ss) / 2;
  row.K_tt = (tt + ss) / 2 + std::sqrt(half * half + ts * ts);
}

bool sticks(const ContactRow& row) {
  const double P_n = row.n.dot(row.P);
  return (row.P - P_n * row.n).norm() < row.friction * P_n * on_the_rim;
}

}  // namespace touchstone::fast::contact
