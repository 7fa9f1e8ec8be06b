#include "fast/impulse.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "fast/lin_canny/rotation.h"
#include "fast/mass.h"
#include "fast/rounding.h"
#include "model/infinity.h"
#include "model/input_error.h"

namespace touchstone::fast {
namespace {

/// A body's data for the impact. For a fixed body only the velocity matters.
///
/// With I = L Lᵀ in the body's axes, M = L⁻¹ Rᵀ maps an angular momentum in W to L⁻¹ times it, and I⁻¹ = Mᵀ M. The
/// product is never formed: where r lies along the axis of a needle, the rounding of its large entries would swamp K.
struct Side {
  double inverse_mass = 0;
  Mat3 M = Mat3::Zero();
  Vec3 r = Vec3::Zero();  ///< from the centre of mass to C, in W
  Vec3 velocity = Vec3::Zero();
  double speed_error = 0;  ///< of the velocity at C, m/s
  /// (The lengths that r was computed from, and its error from that of the centre of mass over 16 u) / sqrt(least
  /// moment of inertia), kg^-1/2.
  double slenderness = 0;
  double mass_error = 0;  ///< of the mass and of L⁻¹ I L⁻ᵀ, relative
};

Side side_of(const Body& body, const Vec3& p_WC) {
  const std::optional<RoundedMass> rounded = rounded_mass(body);
  const MassProperties* const given = rounded ? &rounded->properties : nullptr;
  const Mat3 R = lin_canny::rotation(body.X_WB.q_WB);
  const Vec3 p_WBcm = body.X_WB.p_WB + (given != nullptr ? Vec3(R * given->p_BBcm) : Vec3::Zero());
  const double centre_error = rounded ? rounded->centre_error.norm() : 0;
  Side side;
  side.r = p_WC - p_WBcm;
  side.velocity = body.velocity.v_WBcm + body.velocity.w_WB.cross(side.r);
  const double reach = p_WC.norm() + body.X_WB.p_WB.norm() + (given != nullptr ? given->p_BBcm.norm() : 0.0);
  const double w = body.velocity.w_WB.norm();
  side.speed_error =
      lin_canny::turn_error * w * reach + w * centre_error + 8 * u * (body.velocity.v_WBcm.norm() + w * side.r.norm());
  if (given != nullptr) {
    side.inverse_mass = 1 / given->mass;
    const Eigen::LLT<Mat3> factors = given->I_BBcm_B.llt();
    const Mat3 L = factors.matrixL();
    side.M = L.triangularView<Eigen::Lower>().solve(R.transpose());
    side.slenderness = (reach + centre_error / (16 * u)) / L.diagonal().minCoeff();
    const Mat3 inverse = L.triangularView<Eigen::Lower>().solve(Mat3::Identity()).cwiseAbs();
    side.mass_error = rounded->mass_error + (inverse * rounded->inertia_error * inverse.transpose()).norm();
    if (factors.info() != Eigen::Success) side.mass_error = infinity;
  }
  return side;
}

Mat3 skew(const Vec3& r) {
  Mat3 S;
  S << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
  return S;
}

/// 1/m + (M [r]×)ᵀ (M [r]×): a sum of squares.
Mat3 collision_matrix(const Side& side) {
  const Mat3 W = side.M * skew(side.r);
  Mat3 K = W.transpose() * W;
  K.diagonal().array() += side.inverse_mass;
  return K;
}

/// Two tangents and the normal as columns, right-handed; exact if the normal is an axis. Source: Duff et al. 2017,
/// "Building an orthonormal basis, revisited".
Mat3 contact_frame(const Vec3& n) {
  const double s = std::copysign(1.0, n.z()), a = -1 / (s + n.z()), b = n.x() * n.y() * a;
  Mat3 R;
  R.col(0) = Vec3(1 + s * n.x() * n.x() * a, s * b, -s * n.x());
  R.col(1) = Vec3(b, s + n.y() * n.y() * a, -n.y());
  R.col(2) = n;
  return R;
}

/// Rotates the tangents so that K's tangential block is diagonal: one Jacobi rotation.
void diagonalise(const Mat3& K, Mat3& R) {
  const double off = R.col(0).dot(K * R.col(1));
  if (off == 0) return;
  const double tau = (R.col(1).dot(K * R.col(1)) - R.col(0).dot(K * R.col(0))) / (2 * off);
  const double t = std::copysign(1.0, tau) / (std::abs(tau) + std::sqrt(1 + tau * tau));
  const double c = 1 / std::sqrt(1 + t * t), s = t * c;
  const Vec3 first = R.col(0), second = R.col(1);
  R.col(0) = c * first - s * second;
  R.col(1) = s * first + c * second;
}

struct Stated {
  Side A, B;
  Mat3 K = Mat3::Zero();
  Mat3 R = Mat3::Identity();  ///< axes 1, 2, n in W
  impulse::Impact impact;
};

Stated stated(const Scene& scene) {
  if (!scene.contact) throw InputError("contact", "is missing: an impulse query needs one");
  const Contact& contact = *scene.contact;
  Stated all{side_of(scene.bodies[0], contact.p_WC), side_of(scene.bodies[1], contact.p_WC), {}, {}, {}};
  all.K = collision_matrix(all.A) + collision_matrix(all.B);
  all.R = contact_frame(contact.nhat_BA_W.stableNormalized());
  diagonalise(all.K, all.R);
  const Mat3 K = all.R.transpose() * all.K * all.R;
  const Vec3 v = all.R.transpose() * (all.A.velocity - all.B.velocity);
  all.impact = {K(0, 0),         K(1, 1), K(0, 2), K(1, 2),     K(2, 2),
                v.x(),           v.y(),   v.z(),   contact.law, contact.restitution,
                contact.friction};
  return all;
}

Velocity pushed(const Body& body, const Side& side, const Vec3& P) {
  return {body.velocity.v_WBcm + side.inverse_mass * P,
          body.velocity.w_WB + side.M.transpose() * (side.M * side.r.cross(P))};
}

/// The solver's error; the effect of rounding u, in the norm of K⁻¹; and that of rounding M [r]×: with |δW| ≤ 16 u
/// (slenderness), |K^(-1/2) δ(WᵀW) K^(-1/2)| ≤ 2 |δW|/sqrt(least eigenvalue), and the impulse changes by a few times as
/// much (measured: docs/design/impulse.md); and that of masses computed from densities, which changes K by a share of
/// itself; all over the slope with which u_n reaches its goal. All relative to |u|_{K⁻¹}, or to |P|_K/2 if that is more
/// because Newton's law adds so much energy.
double error_of(const Stated& stated, const Vec3& velocity, const Vec3& P, double flattest) {
  const Eigen::SelfAdjointEigenSolver<Mat3> eigen(stated.K);
  const double least = eigen.eigenvalues()[0], greatest = eigen.eigenvalues()[2];
  if (!(least > 0)) return infinity;
  const Vec3 parts = eigen.eigenvectors().transpose() * velocity;
  const Vec3 pushes = eigen.eigenvectors().transpose() * P;
  const double norm = std::max(std::sqrt((parts.array().square() / eigen.eigenvalues().array()).sum()),
                               std::sqrt((pushes.array().square() * eigen.eigenvalues().array()).sum()) / 2);
  const double speed = (stated.A.speed_error + stated.B.speed_error) / std::sqrt(least);
  const double shape = 32 * u * (stated.A.slenderness + stated.B.slenderness) / std::sqrt(least) +
                       (stated.A.mass_error + stated.B.mass_error);
  return ((impulse::error_bound(greatest / least) + 4 * shape) * norm + 4 * speed) / flattest;
}

/// Is u_n above what rounding changes? Else the bodies may approach by as much, so that the impulse is not exactly 0.
/// The normal and its frame are rounded too: 8 u of |u|.
bool surely_separates(const Stated& stated) {
  const double rounding = stated.A.speed_error + stated.B.speed_error;
  return stated.impact.un > rounding + 8 * u * (stated.A.velocity - stated.B.velocity).norm();
}

}  // namespace

Impacted impact(const Scene& scene) {
  const Stated all = stated(scene);
  Impacted done;
  done.after = {scene.bodies[0].velocity, scene.bodies[1].velocity};
  done.outcome = impulse::solve(all.impact);
  if (!done.outcome.regime.approached) {
    if (!surely_separates(all)) done.error = error_of(all, all.A.velocity - all.B.velocity, Vec3::Zero(), 1);
    return done;
  }
  const impulse::Outcome& out = done.outcome;
  done.P_A_W = all.R * Vec3(out.P1, out.P2, out.p);
  done.after = {pushed(scene.bodies[0], all.A, done.P_A_W), pushed(scene.bodies[1], all.B, -done.P_A_W)};
  const Vec3 velocity = all.A.velocity - all.B.velocity;
  done.error = error_of(all, velocity, done.P_A_W, out.flattest);
  done.energy_change = done.P_A_W.dot(velocity) + done.P_A_W.dot(all.K * done.P_A_W) / 2;
  if (std::isfinite(all.impact.mu)) {
    done.cone_excess = std::sqrt(out.P1 * out.P1 + out.P2 * out.P2) - all.impact.mu * out.p;
  }
  return done;
}

Impulse impulse_of(const Scene& scene) {
  const Impacted done = impact(scene);
  Impulse answer{done.after, done.P_A_W, done.error, {}};
  if (done.outcome.miss < 1e-9) answer.ambiguous = done.outcome.miss;
  return answer;
}

}  // namespace touchstone::fast
