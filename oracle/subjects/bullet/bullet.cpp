#include "oracle/subjects/bullet/bullet.h"

#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>

#include <algorithm>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "oracle/subject.h"
#include "oracle/subjects/bullet/input.h"
#include "oracle/subjects/bullet/snippet.h"

namespace touchstone::oracle::subjects {
namespace {

using namespace in_bullet;

/// The signed distance, the normal from B to A, and the witness on B.
btPointCollector closest_points(const Scene& scene) {
  const Body& A = scene.bodies.at(0);
  const Body& B = scene.bodies.at(1);
  const ConvexPtr shape_A = std::visit(MakeShape{}, A.shape);
  const ConvexPtr shape_B = std::visit(MakeShape{}, B.shape);
  btVoronoiSimplexSolver simplex;
  btGjkEpaPenetrationDepthSolver epa;
  btGjkPairDetector detector(shape_A.get(), shape_B.get(), &simplex, &epa);
  btGjkPairDetector::ClosestPointInput input;
  input.m_transformA = transform(A.X_WB);
  input.m_transformB = transform(B.X_WB);
  input.m_maximumDistanceSquared = std::numeric_limits<btScalar>::max();  // the default ignores distances beyond 1e9 m
  btPointCollector result;
  detector.getClosestPoints(input, result, nullptr);
  if (!result.m_hasResult) throw std::runtime_error("btGjkPairDetector reported no closest points");
  return result;
}

Aabb aabb_of(const Body& body) {
  btVector3 lo;
  btVector3 hi;
  std::visit(MakeShape{}, body.shape)->getAabb(transform(body.X_WB), lo, hi);
  return {vec3(lo), vec3(hi)};
}

/// The mass is passed to Bullet, which takes the body's origin as its centre of mass; only the moments of inertia are
/// computed by Bullet.
struct MassOf {
  double density;

  std::optional<MassProperties> operator()(const Sphere& s) const {
    return with_inertia(s, 4.0 / 3 * std::numbers::pi * s.radius * s.radius * s.radius);
  }
  std::optional<MassProperties> operator()(const Box& b) const { return with_inertia(b, 8 * b.half_extents.prod()); }
  std::optional<MassProperties> operator()(const Polytope&) const { return std::nullopt; }
  std::optional<MassProperties> operator()(const Compound&) const { return std::nullopt; }

  template <class Primitive>
  MassProperties with_inertia(const Primitive& primitive, double volume) const {
    const double mass = density * volume;
    btVector3 moments;
    MakeShape{}(primitive)->calculateLocalInertia(scalar(mass), moments);
    return {mass, Vec3::Zero(), Mat3(vec3(moments).asDiagonal())};
  }
};

const std::string issues = "https://github.com/bulletphysics/bullet3/issues/";

class Bullet : public Subject {
 public:
  const Card& card() const override { return card_; }

  Answer<Masses> mass(const Scene& scene) override {
    Masses said;
    for (const Body& body : scene.bodies) {
      const Density* density = std::get_if<Density>(&body.mass);
      const MassProperties* given = std::get_if<MassProperties>(&body.mass);
      said.push_back(given ? std::optional(*given) : std::nullopt);
      if (!density) continue;
      said.back() = std::visit(MassOf{density->value}, body.shape);
      if (!said.back()) return Abstains{"Bullet does not compute the mass or the centre of mass of a hull"};
    }
    return said;
  }

  Answer<Bounds> bounds(const Scene& scene) override {
    if (has_compound(scene)) return no_compounds;
    Bounds said;
    for (const Body& body : scene.bodies) said.push_back(aabb_of(body));
    return said;
  }

  Answer<PairSet> broad_phase(const Scene& scene) override {
    if (has_compound(scene)) return no_compounds;
    std::vector<int> indices(scene.bodies.size());
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher(&configuration);
    btDbvtBroadphase broadphase;
    std::vector<btBroadphaseProxy*> proxies;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      const Body& body = scene.bodies[i];
      btVector3 lo;
      btVector3 hi;
      const ConvexPtr shape = std::visit(MakeShape{}, body.shape);
      shape->getAabb(transform(body.X_WB), lo, hi);
      indices[i] = static_cast<int>(i);
      proxies.push_back(broadphase.createProxy(lo, hi, shape->getShapeType(), &indices[i],
                                               btBroadphaseProxy::DefaultFilter, btBroadphaseProxy::AllFilter,
                                               &dispatcher));
    }
    broadphase.calculateOverlappingPairs(&dispatcher);
    PairSet pairs;
    const btBroadphasePairArray& found = broadphase.getOverlappingPairCache()->getOverlappingPairArray();
    for (int i = 0; i < found.size(); ++i) {
      const auto index = [](const btBroadphaseProxy* proxy) { return *static_cast<const int*>(proxy->m_clientObject); };
      pairs.push_back(std::minmax(index(found[i].m_pProxy0), index(found[i].m_pProxy1)));
    }
    for (btBroadphaseProxy* proxy : proxies) broadphase.destroyProxy(proxy, &dispatcher);
    std::sort(pairs.begin(), pairs.end());
    return pairs;
  }

  Answer<Distance> distance(const Scene& scene) override {
    if (has_compound(scene)) return no_compounds;
    const btPointCollector found = closest_points(scene);
    if (found.m_distance < 0) return in_collision();
    return apart(found.m_distance, vec3(found.m_pointInWorld + found.m_distance * found.m_normalOnBInWorld),
                 vec3(found.m_pointInWorld));
  }

  Answer<Penetration> penetration(const Scene& scene) override {
    if (has_compound(scene)) return no_compounds;
    const btPointCollector found = closest_points(scene);
    if (found.m_distance >= 0) return no_penetration();
    return deep(-found.m_distance, vec3(found.m_normalOnBInWorld));
  }

  Answer<std::string> reproduce(const std::string& query, const Scene& scene, const std::string& expected) override {
    if (query != "distance" && query != "penetration") return Abstains{"no snippets of " + query};
    if (has_compound(scene)) return no_compounds;
    return pair_snippet(scene, is_double ? "bullet-float64" : "bullet", expected);
  }

 private:
  const Card card_{
      .name = is_double ? "bullet.double" : "bullet.float",
      .version = std::to_string(btGetVersion() / 100) + "." + std::to_string(btGetVersion() % 100),
      .precision = is_double ? Precision::binary64 : Precision::binary32,
      .answers = {"mass", "bounds", "broad_phase", "distance", "penetration"},
      .about =
          "btGjkPairDetector with btVoronoiSimplexSolver and btGjkEpaPenetrationDepthSolver, margin 0 (its default is "
          "0.04 m); getAabb; btDbvtBroadphase; calculateLocalInertia of spheres and boxes",
      .homepage = "https://github.com/bulletphysics/bullet3",
      .deviations = {{"", "normals flip and the error grows as two shapes near each other", issues + "889"},
                     {"", "a positive distance for boxes of margin 0 that penetrate", issues + "1703"}},
      .domain = in_bullet::domain(),
      .boxes = BoxKind::of_turned_box,
      .reproduces = {"distance", "penetration"}};
};

}  // namespace

std::unique_ptr<Subject> make_bullet() { return std::make_unique<Bullet>(); }

}  // namespace touchstone::oracle::subjects
