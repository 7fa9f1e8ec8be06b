#include "oracle/tolerance/precision.h"

#include <algorithm>
#include <cmath>

namespace touchstone::oracle {
namespace {

bool single(double x) { return static_cast<double>(static_cast<float>(x)) == x; }

bool single(const Vec3& v) { return single(v.x()) && single(v.y()) && single(v.z()); }

bool single(const Pose& X) {
  return single(X.p_WB) && single(X.q_WB.w) && single(X.q_WB.x) && single(X.q_WB.y) && single(X.q_WB.z);
}

bool single(const Sphere& s) { return single(s.radius); }
bool single(const Box& b) { return single(b.half_extents); }
bool single(const Polytope& p) {
  return std::ranges::all_of(p.vertices, [](const Vec3& v) { return single(v); });
}
bool single(const Compound& c) {
  return std::ranges::all_of(c.parts, [](const Part& part) {
    return single(part.X_BP) && std::visit([](const auto& shape) { return single(shape); }, part.shape);
  });
}

bool single(const Density& d) { return single(d.value); }
bool single(const MassProperties& m) {
  return single(m.mass) && single(m.p_BBcm) &&
         std::all_of(m.I_BBcm_B.data(), m.I_BBcm_B.data() + 9, [](double x) { return single(x); });
}
bool single(const Fixed&) { return true; }

bool single(const Raster& raster) { return single(raster.x) && single(raster.y) && single(raster.pixel); }

bool single(const Velocity& V) { return single(V.v_WBcm) && single(V.w_WB); }
bool single(const Contact& contact) {
  return single(contact.p_WC) && single(contact.nhat_BA_W) && single(contact.restitution) && single(contact.friction);
}

bool single(const std::vector<double>& numbers) {
  return std::ranges::all_of(numbers, [](double x) { return single(x); });
}
bool single(const Motion& motion) {
  const auto force = [](const AppliedForce& p) { return single(p.time) && single(p.force_W); };
  return single(motion.sample_times) && single(motion.start_times) && single(motion.envelope.value_or(0)) &&
         single(motion.force_bound) && std::ranges::all_of(motion.forces, force);
}

bool single(const Body& body) {
  const auto each = [](const auto& alternative) { return single(alternative); };
  return single(body.X_WB) && std::visit(each, body.shape) && std::visit(each, body.mass);
}

}  // namespace

double unit_roundoff(Precision precision) { return std::ldexp(1.0, precision == Precision::binary32 ? -24 : -53); }

bool exact_in(const Scene& scene, Precision precision) {
  if (precision != Precision::binary32) return true;
  if (scene.raster && !single(*scene.raster)) return false;
  const auto placed = [](const Placement& p) { return !p.X_WB || single(*p.X_WB); };
  const auto moving = [](const Body& b) { return single(b.velocity); };
  if (scene.contact && !(single(*scene.contact) && std::ranges::all_of(scene.bodies, moving))) return false;
  const auto material = [](const Body& b) { return single(b.material.restitution) && single(b.material.friction); };
  if (scene.motion && !(single(*scene.motion) && single(scene.gravity) && std::ranges::all_of(scene.bodies, moving) &&
                        std::ranges::all_of(scene.bodies, material))) {
    return false;
  }
  return std::ranges::all_of(scene.bodies, [](const Body& b) { return single(b); }) &&
         std::ranges::all_of(scene.frames, [&](const SequenceFrame& f) { return std::ranges::all_of(f, placed); });
}

}  // namespace touchstone::oracle
