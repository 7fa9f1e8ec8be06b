#include "oracle/subjects/bullet/snippet.h"

#include "oracle/subjects/common/snippet.h"

namespace touchstone::oracle::subjects::in_bullet {
namespace {

struct Declared {
  std::string name;

  std::string operator()(const Sphere& sphere) const {
    return fmt::format("  btSphereShape {}({});\n", name, cpp_number(sphere.radius));
  }
  std::string operator()(const Box& box) const {
    return fmt::format("  btBoxShape {0}(btVector3({1}));\n  {0}.setMargin(0);\n", name, cpp_list(box.half_extents));
  }
  std::string operator()(const Polytope& polytope) const {
    std::string text = fmt::format("  btConvexHullShape {0};\n  {0}.setMargin(0);\n", name);
    for (const Vec3& v : polytope.vertices)
      text += fmt::format("  {}.addPoint(btVector3({}), false);\n", name, cpp_list(v));
    return text + fmt::format("  {}.recalcLocalAabb();\n", name);
  }
  std::string operator()(const Compound&) const { return ""; }
};

std::string transform_text(const Pose& X_WB) {
  return fmt::format("btTransform(btQuaternion({}), btVector3({}))", cpp_rotation_xyzw(X_WB.q_WB), cpp_list(X_WB.p_WB));
}

}  // namespace

std::string pair_snippet(const Scene& scene, const std::string& package, const std::string& expected) {
  const Body &A = scene.bodies.at(0), &B = scene.bodies.at(1);
  return fmt::format(R"(// g++ pair.cpp $(pkg-config --cflags --libs {}) -o pair && ./pair
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <btBulletCollisionCommon.h>

#include <cstdio>
#include <limits>

int main() {{
{}{}{}  btVoronoiSimplexSolver simplex;
  btGjkEpaPenetrationDepthSolver epa;
  btGjkPairDetector detector(&A, &B, &simplex, &epa);
  btGjkPairDetector::ClosestPointInput input;
  input.m_transformA = {};
  input.m_transformB = {};
  input.m_maximumDistanceSquared = std::numeric_limits<btScalar>::max();
  btPointCollector found;
  detector.getClosestPoints(input, found, nullptr);
  const btVector3 &p = found.m_pointInWorld, &n = found.m_normalOnBInWorld;
  std::printf("distance: %.17g\n", double(found.m_distance));  // below 0 if they overlap
  std::printf("on B: %.17g %.17g %.17g\n", double(p.x()), double(p.y()), double(p.z()));
  std::printf("normal from B to A: %.17g %.17g %.17g\n", double(n.x()), double(n.y()), double(n.z()));
}}
)",
                     package, cpp_printed(expected), std::visit(Declared{"A"}, A.shape),
                     std::visit(Declared{"B"}, B.shape), transform_text(A.X_WB), transform_text(B.X_WB));
}

}  // namespace touchstone::oracle::subjects::in_bullet
