#include "fast/simulation/exact_momentum.h"

#include <algorithm>
#include <cmath>

#include "model/input_error.h"

namespace touchstone::fast::simulation {
namespace {

Vec3 on_grid(const Vec3& P, double grid) {
  return grid * (P / grid).unaryExpr([](double x) { return std::floor(x + 0.5); });
}

}  // namespace

ExactMomentum::ExactMomentum(const World& world) : world_(&world) {
  if (!world.scene().gravity.isZero(0) || !world.scene().motion->forces.empty()) {
    throw InputError("gravity", "changes momentum; it can be kept exact only without gravity and applied forces");
  }
  double energy = 0, heaviest = 0;
  for (const BodyMotion& body : world.bodies()) {
    if (body.fixed()) continue;
    const Vec3 w = body.path().w;
    energy += body.path().v.squaredNorm() / body.inverse_mass() / 2 + w.squaredNorm() * inertia(body).trace() / 2;
    heaviest = std::max(heaviest, 1 / body.inverse_mass());
  }
  int exponent = 0;
  std::frexp(std::sqrt(2 * heaviest * energy), &exponent);
  grid_ = std::ldexp(1, exponent - 50);
  for (const BodyMotion& body : world.bodies()) {
    momentum_.push_back(body.fixed() ? Vec3(Vec3::Zero()) : on_grid(body.path().v / body.inverse_mass(), grid_));
  }
  before_ = momentum_;
}

void ExactMomentum::apply(BodyId a, BodyId b, ImpactResult& result) {
  result.P_A_W = on_grid(result.P_A_W, grid_);
  momentum_[a] += result.P_A_W;
  momentum_[b] -= result.P_A_W;
  const BodyMotion &A = world_->body(a), &B = world_->body(b);
  if (!A.fixed()) result.after_a.v_WBcm = A.inverse_mass() * momentum_[a];
  if (!B.fixed()) result.after_b.v_WBcm = B.inverse_mass() * momentum_[b];
}

}  // namespace touchstone::fast::simulation
