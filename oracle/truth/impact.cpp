#include "oracle/truth/impact.h"

#include <Eigen/Dense>
#include <cmath>

#include "oracle/truth/truth.h"

namespace touchstone::oracle {
namespace {

Real middle(const Interval& i) { return (static_cast<Real>(i.lo) + static_cast<Real>(i.hi)) / 2; }

Matrix cross(const Point& r) {
  Matrix m;
  m << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
  return m;
}

Point at_contact(const Point& v_WBcm, const Point& w_WB, const ImpactBody& body) {
  return v_WBcm + w_WB.cross(body.p_BcmC_W);
}

}  // namespace

Matrix rotation_matrix(const Quaternion& q) {
  return Eigen::Quaternion<Real>(q.w, q.x, q.y, q.z).normalized().toRotationMatrix();
}

ImpactBody impact_body(const Scene& scene, std::size_t index, const Vec3& p_WC) {
  const Body& body = scene.bodies[index];
  const std::optional<reference::MassTruth>& mass = truth::mass(scene)[index];
  ImpactBody it;
  it.v_WBcm = body.velocity.v_WBcm.cast<Real>();
  it.w_WB = body.velocity.w_WB.cast<Real>();
  it.fixed = !mass;
  it.p_BcmC_W = p_WC.cast<Real>() - body.X_WB.p_WB.cast<Real>();
  if (it.fixed) return it;
  it.R_WB = rotation_matrix(body.X_WB.q_WB);
  it.mass = middle(mass->mass);
  it.p_BBcm = Point(middle(mass->p_BBcm[0]), middle(mass->p_BBcm[1]), middle(mass->p_BBcm[2]));
  it.p_BcmC_W -= it.R_WB * it.p_BBcm;
  const auto I = [&](std::size_t i) { return middle(mass->I_BBcm_B[i]); };
  it.I_B << I(0), I(3), I(4), I(3), I(1), I(5), I(4), I(5), I(2);
  it.I_inverse_B = it.I_B.inverse();
  it.moments = Eigen::SelfAdjointEigenSolver<Matrix>(it.I_B, Eigen::EigenvaluesOnly).eigenvalues();
  return it;
}

Point Impact::impulse_for(const Point& du) const {
  const auto lower = L.triangularView<Eigen::Lower>();
  return lower.transpose().solve(lower.solve(du));
}

Matrix Impact::K_inverse() const {
  const Matrix root = L.triangularView<Eigen::Lower>().solve(Matrix::Identity());
  return root.transpose() * root;
}

Real Impact::energy_norm(const Point& du) const { return L.triangularView<Eigen::Lower>().solve(du).norm(); }

Real Impact::condition() const {
  const Point values = Eigen::SelfAdjointEigenSolver<Matrix>(K, Eigen::EigenvaluesOnly).eigenvalues();
  return values[2] / values[0];
}

Real Impact::least_mass() const {
  Real inverse = 0;
  for (const ImpactBody& body : bodies) inverse += body.fixed ? 0 : 1 / body.mass;
  return 1 / inverse;
}

Point Impact::u_after(const std::array<Velocity, 2>& after) const {
  const auto point = [&](std::size_t i) {
    return at_contact(after[i].v_WBcm.cast<Real>(), after[i].w_WB.cast<Real>(), bodies[i]);
  };
  return point(0) - point(1);
}

Impact impact(const Scene& scene) {
  Impact it;
  it.nhat_BA_W = scene.contact->nhat_BA_W.cast<Real>().normalized();
  for (std::size_t i = 0; i < 2; ++i) {
    ImpactBody& body = it.bodies[i] = impact_body(scene, i, scene.contact->p_WC);
    const Matrix r_B = cross(body.R_WB.transpose() * body.p_BcmC_W);
    if (!body.fixed) {
      it.K += Matrix::Identity() / body.mass - body.R_WB * (r_B * body.I_inverse_B * r_B) * body.R_WB.transpose();
    }
    it.u += (i == 0 ? 1 : -1) * at_contact(body.v_WBcm, body.w_WB, body);
  }
  it.K = ((it.K + it.K.transpose()) / 2).eval();
  it.L = it.K.llt().matrixL();
  return it;
}

}  // namespace touchstone::oracle
