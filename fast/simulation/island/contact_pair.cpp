#include "fast/simulation/island/contact_pair.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "fast/contact/parting.h"
#include "fast/lin_canny/proximity.h"
#include "fast/mark.h"
#include "fast/simulation/island/approach_normal.h"
#include "fast/simulation/prediction/length.h"

namespace touchstone::fast::simulation {
namespace {

constexpr double tied = 0x1p-10;  // of `near`: separations that differ by less are equal; steps are as accurate as that

/// The direction of greatest separation among n, the contact point's normal, and the normals of nearby faces of A and
/// B; n if it is the greatest up to `tie` (m). Otherwise the normal would change with rounding between two faces that
/// are nearly parallel, and with it which corners are said to be above the other part.
Vec3 separating_direction(const contact::Part& A, const contact::Part& B, const Vec3& n, double tie) {
  Vec3 best = n;
  double widest = apart(A, B, n) + tie;
  for (const Vec3& other : contact::faces_along(A, B, n)) {
    const double wide = apart(A, B, other);
    if (wide > widest) widest = wide, best = other;
  }
  return best;
}

lin_canny::Proximity proximity_of(const contact::Part& A, const State& at_a, const contact::Part& B,
                                  const State& at_b) {
  lin_canny::FeaturePair memory;
  return lin_canny::proximity(*A.convex, lin_canny::CachedPose(at_a.X_WB), *B.convex, lin_canny::CachedPose(at_b.X_WB),
                              memory);
}

Vec3 parting(const contact::Part& A, const State& at_a, const contact::Part& B, const State& at_b) {
  return contact::parting(A, lin_canny::CachedPose(at_a.X_WB), B, lin_canny::CachedPose(at_b.X_WB));
}

/// Whether a point is in the part, or beside each of its faces by at most `within` (m). True of a ball, which has none.
bool is_within(const contact::Part& part, const Vec3& p_W, double within) {
  const lin_canny::Hull& hull = *part.core.hull;
  const Vec3 p = part.core.in(p_W);
  for (int f = 0; f < hull.face_count(); ++f) {
    if (hull.face(f).normal.dot(p) > hull.face(f).height + within) return false;
  }
  return true;
}

Vec3 normal_at(const contact::ContactPoint& contact_point, const contact::Part& A, const contact::Part& B,
               const Vec3& about) {
  return nearness(contact_point.a, A.body, contact_point.b, B.body, about).nhat_BA_W;
}

Vec3 normal(const ContactPair& contact_pair, const contact::Part& A, const State& at_a, const contact::Part& B,
            const State& at_b, double near) {
  if (contact_pair.shared) {
    const Vec3 n = normal_at(*contact_pair.shared, A, B, contact_pair.nhat_BA_W);
    if (separates(apart(A, B, n), near)) return n;
  }
  if (contact_pair.contact_points.empty()) return parting(A, at_a, B, at_b);
  const Vec3 n = separating_direction(
      A, B, normal_at(contact_pair.contact_points.front(), A, B, contact_pair.nhat_BA_W), tied * near);
  const double wide = apart(A, B, n);
  if (separates(wide, near)) return n;
  const Vec3 other = parting(A, at_a, B, at_b);
  return apart(A, B, other) > wide ? other : n;
}

/// The middle of points that are on one segment up to `within` (m); none if they are not, and then they span a face.
std::optional<Vec3> middle_of_segment(const std::vector<Vec3>& points, double within) {
  if (points.empty()) return {};
  const auto farthest_from = [&](const Vec3& from) {
    return *std::ranges::max_element(points, {}, [&](const Vec3& p) { return (p - from).squaredNorm(); });
  };
  const Vec3 end = farthest_from(points.front()), other = farthest_from(end), along = (other - end).normalized();
  const auto is_beside = [&](const Vec3& p) { return (p - end).cross(along).norm() > within; };
  if (std::ranges::any_of(points, is_beside)) return {};
  return (end + other) / 2;
}

}  // namespace

contact::Part part_of(const IslandBody& island_body, std::size_t part, const State& state) {
  contact::StepBody there = island_body.step_body;
  there.state = state;
  return contact::part_of(island_body.body->model().solid.parts()[part], lin_canny::CachedPose(state.X_WB),
                          there.transform());
}

std::vector<contact::ContactPoint> points_along(const contact::Part& A, const contact::Part& B, const Vec3& n,
                                                double near) {
  const double gap = apart(A, B, n);
  if (gap > near) return {};
  return contact::contact_points(A, B, n, near + std::max(0.0, -gap));
}

double speed_bound(const IslandBody& island_body, double h) {
  const Velocity& V = island_body.state().velocity;
  return length(V.v_WBcm) + length(V.w_WB) * island_body.body->radius() +
         h * length(island_body.step_body.acceleration);
}

bool update(ContactPair& contact_pair, const IslandBody& body_a, const IslandBody& body_b, double near, double reach) {
  const State &at_a = body_a.state(), &at_b = body_b.state();
  const contact::Part A = part_of(body_a, contact_pair.part_a, at_a), B = part_of(body_b, contact_pair.part_b, at_b);
  contact_pair.shared.reset();
  contact_pair.nhat_BA_W = normal(contact_pair, A, at_a, B, at_b, near);
  const double gap = apart(A, B, contact_pair.nhat_BA_W);
  if (gap > reach) return false;
  std::vector<contact::ContactPoint> contact_points = points_along(A, B, contact_pair.nhat_BA_W, near);
  if (gap <= near && contact_points.empty()) {
    const lin_canny::Proximity found = proximity_of(A, at_a, B, at_b);
    contact_pair.nhat_BA_W = contact::parting(A, B, found);
    if (apart(A, B, contact_pair.nhat_BA_W) <= near)
      contact_points = contact::contact_points(A, B, contact_pair.nhat_BA_W, near);
    if (contact_points.empty() && !(found.distance > near)) {
      contact_points = {contact::contact_point_between(A, found.p_WCa, B, found.p_WCb, contact_pair.nhat_BA_W)};
    }
  }
  // Initial guess: the forces of the last step, if the points may be the same ones.
  for (std::size_t i = 0; i < contact_points.size() && contact_points.size() == contact_pair.contact_points.size();
       ++i) {
    contact_points[i].F_A_W = contact_pair.contact_points[i].F_A_W;
    contact_points[i].h = contact_pair.contact_points[i].h;
  }
  contact_pair.contact_points = std::move(contact_points);
  return true;
}

void choose_normal_of_approach(ContactPair& contact_pair, const IslandBody& body_a, const IslandBody& body_b,
                               double near) {
  if (contact_pair.shared) return;
  std::vector<Vec3> points;
  for (const contact::ContactPoint& point : contact_pair.contact_points)
    points.push_back(candidate_at(contact_pair, point, body_a, body_b).touch.p_WC);
  const std::optional<Vec3> middle = middle_of_segment(points, 2 * near);
  if (!middle) return;
  const contact::Part A = part_of(body_a, contact_pair.part_a, body_a.state()),
                      B = part_of(body_b, contact_pair.part_b, body_b.state());
  const Vec3 u = relative_velocity(*body_a.body, body_a.state(), *body_b.body, body_b.state(), *middle);
  const std::optional<Vec3> n = approach_normal(A, B, u);
  if (!n) return;
  std::vector<contact::ContactPoint> contact_points = contact::contact_points(A, B, *n, near);
  if (contact_points.empty()) return;
  mark(Mark::impact_tied);
  contact_pair.nhat_BA_W = *n;
  contact_pair.contact_points = std::move(contact_points);
  contact_pair.p_WC = candidate_at(contact_pair, contact_pair.contact_points.front(), body_a, body_b).touch.p_WC;
}

ImpactCandidate candidate_at(const ContactPair& contact_pair, const contact::ContactPoint& contact_point,
                             const IslandBody& A, const IslandBody& B) {
  const contact::Nearness near = nearness(contact_point.a, A.step_body.transform(), contact_point.b,
                                          B.step_body.transform(), contact_pair.nhat_BA_W);
  const Vec3 n = near.nhat_BA_W.normalized();  // the normal of a plane may be off by a few u
  const Touch touch{near.gap, near.p_WC - near.gap / 2 * n, n};
  return {contact_pair.a, contact_pair.b, touch, normal_velocity(*A.body, A.state(), *B.body, B.state(), touch)};
}

double distance(const ContactPair& contact_pair, const IslandBody& body_a, const State& at_a, const IslandBody& body_b,
                const State& at_b) {
  const contact::Part A = part_of(body_a, contact_pair.part_a, at_a), B = part_of(body_b, contact_pair.part_b, at_b);
  return proximity_of(A, at_a, B, at_b).distance;
}

bool have_come_apart(const ContactPair& contact_pair, std::span<const contact::ContactConstraint> constraints,
                     const IslandBody& body_a, const State& at_a, const IslandBody& body_b, const State& at_b,
                     double within) {
  const auto presses = [](const contact::ContactConstraint& c) { return !c.contact_point.F_A_W.isZero(0); };
  if (std::ranges::none_of(constraints, presses)) return false;
  const contact::Part A = part_of(body_a, contact_pair.part_a, at_a), B = part_of(body_b, contact_pair.part_b, at_b);
  const auto is_on_both = [&](const contact::ContactConstraint& c) {
    const contact::Nearness near =
        nearness(c.contact_point.a, A.body, c.contact_point.b, B.body, contact_pair.nhat_BA_W);
    return is_within(A, near.p_WC, within) && is_within(B, near.p_WC - near.gap * near.nhat_BA_W, within);
  };
  const auto holds = [&](const contact::ContactConstraint& c) { return presses(c) && is_on_both(c); };
  return std::ranges::none_of(constraints, holds) && proximity_of(A, at_a, B, at_b).distance > within;
}

std::vector<double> clearances(const ContactPair& contact_pair, const IslandBody& body_a, const State& at_a,
                               const IslandBody& body_b, const State& at_b, double near) {
  const contact::Part A = part_of(body_a, contact_pair.part_a, at_a), B = part_of(body_b, contact_pair.part_b, at_b);
  return contact::clearances(A, B, normal(contact_pair, A, at_a, B, at_b, near));
}

std::vector<double> clearance_rates(const ContactPair& contact_pair, const IslandBody& body_a,
                                    const IslandBody& body_b) {
  const Vec3& n = contact_pair.nhat_BA_W;
  const auto rates = [&n](const IslandBody& island_body, const contact::Part& part) {
    const Velocity& V = island_body.state().velocity;
    std::vector<double> all;
    for (int v = 0; v < part.core.hull->vertex_count(); ++v)
      all.push_back(n.dot(V.v_WBcm) + n.dot(V.w_WB.cross(part.core.vertex(v) - part.body.centre)));
    return all;
  };
  const auto lowest_vertex = [](const contact::Part& part, const Vec3& along) {
    int lowest = 0;
    for (int v = 1; v < part.core.hull->vertex_count(); ++v) {
      if (along.dot(part.core.vertex(v)) < along.dot(part.core.vertex(lowest))) lowest = v;
    }
    return static_cast<std::size_t>(lowest);
  };
  const contact::Part A = part_of(body_a, contact_pair.part_a, body_a.state()),
                      B = part_of(body_b, contact_pair.part_b, body_b.state());
  std::vector<double> all = rates(body_a, A);
  const std::vector<double> of_B = rates(body_b, B);
  const double low = all[lowest_vertex(A, n)], high = of_B[lowest_vertex(B, -n)];
  for (double& rate : all) rate -= high;
  for (const double rate : of_B) all.push_back(low - rate);
  return all;
}

}  // namespace touchstone::fast::simulation
