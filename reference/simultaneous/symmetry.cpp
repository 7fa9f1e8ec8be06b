#include "reference/simultaneous/symmetry.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "reference/exact/dense.h"

namespace touchstone::reference {
namespace {

/// x ↦ x or 2c − x, coordinate by coordinate.
struct Reflection {
  Vec3 signs, twice_centre;

  Vec3 vector(const Vec3& v) const { return v.cwiseProduct(signs); }
  Vec3 axial(const Vec3& w) const { return signs.prod() * vector(w); }
  Vec3 point(const Vec3& p) const { return vector(p) + (Vec3::Ones() - signs).cwiseProduct(twice_centre) / 2; }
};

const Body& body(const ReportedImpacts& reported, int i) { return reported.before.bodies[index(i)]; }

/// Whether g takes the first body to the second one. Only poses without rotation, so that inertia keeps its axes.
bool maps(const Reflection& g, const Body& from, const Body& to) {
  const Quaternion unturned;
  if (!(from.X_WB.q_WB == unturned) || !(to.X_WB.q_WB == unturned)) return false;
  if (!(from.material == to.material) || from.mass.index() != to.mass.index()) return false;
  if (g.vector(from.velocity.v_WBcm) != to.velocity.v_WBcm || g.axial(from.velocity.w_WB) != to.velocity.w_WB)
    return false;
  if (is_fixed(from)) return from.velocity.w_WB.isZero(0);  // the velocity of its origin is that of all its points
  if (g.point(from.X_WB.p_WB) != to.X_WB.p_WB) return false;
  if (const auto* given = std::get_if<MassProperties>(&from.mass)) {
    MassProperties reflected = *given;
    reflected.p_BBcm = g.vector(given->p_BBcm);
    reflected.I_BBcm_B = g.signs.asDiagonal() * given->I_BBcm_B * g.signs.asDiagonal();
    return reflected == std::get<MassProperties>(to.mass);
  }
  // A box is its own mirror image; other shapes with a density are not compared.
  const auto* box = std::get_if<Box>(&from.shape);
  const auto* other = std::get_if<Box>(&to.shape);
  return from.mass == to.mass && box != nullptr && other != nullptr && *box == *other;
}

/// Whether g takes the first region to the second one, with the bodies in either order.
bool maps(const Reflection& g, const ReportedImpacts& reported, const ContactRegion& from, const ContactRegion& to) {
  const bool same = maps(g, body(reported, from.a), body(reported, to.a)) &&
                    maps(g, body(reported, from.b), body(reported, to.b)) && g.vector(from.nhat_BA_W) == to.nhat_BA_W;
  const bool exchanged = maps(g, body(reported, from.a), body(reported, to.b)) &&
                         maps(g, body(reported, from.b), body(reported, to.a)) &&
                         g.vector(from.nhat_BA_W) == -to.nhat_BA_W;
  const auto contains = [](const std::vector<Vec3>& points, const Vec3& x) {
    return std::ranges::count(points, x) > 0;
  };
  return (same || exchanged) && from.points_W.size() == to.points_W.size() &&
         std::ranges::all_of(from.points_W, [&](const Vec3& x) { return contains(to.points_W, g.point(x)); });
}

/// The pairs of bodies that move, each with its image; empty if g is no symmetry.
std::vector<std::pair<std::size_t, std::size_t>> images(const Reflection& g, const ReportedImpacts& reported) {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  const std::vector<Body>& bodies = reported.before.bodies;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (is_fixed(bodies[i])) continue;
    const auto image = std::ranges::find_if(bodies, [&](const Body& to) { return maps(g, bodies[i], to); });
    if (image == bodies.end()) return {};
    pairs.emplace_back(i, static_cast<std::size_t>(image - bodies.begin()));
  }
  for (const ContactRegion& from : reported.regions) {
    if (std::ranges::none_of(reported.regions, [&](const ContactRegion& to) { return maps(g, reported, from, to); }))
      return {};
  }
  return pairs;
}

/// Twice the middle of the bodies that move.
Vec3 twice_centre(const ReportedImpacts& reported) {
  std::optional<Vec3> least, most;
  for (const Body& each : reported.before.bodies) {
    if (is_fixed(each)) continue;
    least = least ? least->cwiseMin(each.X_WB.p_WB) : each.X_WB.p_WB;
    most = most ? most->cwiseMax(each.X_WB.p_WB) : each.X_WB.p_WB;
  }
  return least ? Vec3(*least + *most) : Vec3::Zero();
}

}  // namespace

double asymmetry(const ReportedImpacts& reported, double longest_arm) {
  double worst = 0;
  for (int k = 1; k < 8; ++k) {
    const Reflection g{Vec3(k & 1 ? -1 : 1, k & 2 ? -1 : 1, k & 4 ? -1 : 1), twice_centre(reported)};
    for (const auto& [i, image] : images(g, reported)) {
      const Vec3 v = g.vector(reported.after[i].v_WBcm) - reported.after[image].v_WBcm;
      const Vec3 w = g.axial(reported.after[i].w_WB) - reported.after[image].w_WB;
      worst = std::max({worst, v.norm(), longest_arm * w.norm()});
    }
  }
  return worst;
}

}  // namespace touchstone::reference
